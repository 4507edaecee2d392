#include "gates/agreement.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <stdexcept>

#include "object_shape.h"
#include "wardslam/mapping/cloud_in_map.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::gates {
namespace {

using Poses = std::map<std::uint64_t, Eigen::Isometry3d>;
using ObjectPoints = std::map<mapping::ObjectId, std::vector<Eigen::Vector3f>>;

/// Where the trajectory says that the keyframes were taken.
Poses posesByTrajectory(const mapping::SemanticMap& map, const core::Trajectory& trajectory) {
  constexpr double kSameStamp_s = 1e-4;
  Poses poses;
  for (const auto& [id, keyframe] : map.keyframes) {
    const auto pose = std::find_if(trajectory.begin(), trajectory.end(), [&](const core::StampedPose& p) {
      return std::abs(p.stamp_s - keyframe.stamp_s) < kSameStamp_s;
    });
    if (pose == trajectory.end()) throw std::runtime_error("a keyframe has no pose in the trajectory");
    poses[id] = pose->T_map_cam;
  }
  return poses;
}

mapping::SemanticMap placed(mapping::SemanticMap map, const Poses& poses) {
  for (auto& [id, keyframe] : map.keyframes) keyframe.T_map_cam = poses.at(id);
  return map;
}

/// In double precision, unlike forEachCloudPoint(): differences of a micrometre count.
std::vector<Eigen::Vector3d> cloudOf(const mapping::SemanticMap& map) {
  std::vector<Eigen::Vector3d> points_m;
  for (const auto& [id, tile] : map.cloud) {
    const Eigen::Isometry3d& T_map_cam = map.keyframes.at(id).T_map_cam;
    for (const auto& point : tile.points) points_m.emplace_back(T_map_cam * point.p_cam_m.cast<double>());
  }
  return points_m;
}

/// Farthest centroid from that of the thing's points. What is gone has none.
double farthestObject_m(const mapping::SemanticMap& map) {
  ObjectPoints points_m;
  mapping::forEachCloudPoint(map, [&](const Eigen::Vector3f& p_m, const mapping::SemanticPoint& point) {
    if (point.object != 0) points_m[point.object].push_back(p_m);
  });
  double farthest_m = 0.0;
  for (const auto& [id, object] : map.objects) {
    if (object.state == mapping::ObjectState::Gone) continue;
    const auto centroid_m = mapping::shapeOf(points_m.at(id), mapping::kPartGap_m).centroid_m;
    farthest_m = std::max(farthest_m, (centroid_m - object.centroid_m).norm());
  }
  return farthest_m;
}

}  // namespace

Disagreement disagreementOf(const Run& run) {
  const auto map = storage::MapFile::open(run.map()).read();
  const auto byTrajectory = placed(map, posesByTrajectory(map, run.trajectory()));
  Disagreement result;
  result.keyframes = map.keyframes.size();
  result.objects = map.objects.size();
  for (const auto& [id, keyframe] : map.keyframes) {
    const Eigen::Vector3d step_m =
        keyframe.T_map_cam.translation() - byTrajectory.keyframes.at(id).T_map_cam.translation();
    result.keyframe_m = std::max(result.keyframe_m, step_m.norm());
  }
  const auto inFile_m = cloudOf(map);
  const auto inTrajectory_m = cloudOf(byTrajectory);
  result.cloudPoints = inFile_m.size();
  for (std::size_t i = 0; i < inFile_m.size(); ++i) {
    result.cloud_m = std::max(result.cloud_m, (inFile_m[i] - inTrajectory_m[i]).norm());
  }
  result.object_m = farthestObject_m(byTrajectory);
  result.objectInFile_m = farthestObject_m(map);
  std::printf(
      "%zu keyframes off by up to %.5f mm, %zu points by %.5f mm, %zu things by %.5f mm (from the file's cloud %.5f "
      "mm)\n",
      result.keyframes, 1e3 * result.keyframe_m, result.cloudPoints, 1e3 * result.cloud_m, result.objects,
      1e3 * result.object_m, 1e3 * result.objectInFile_m);
  return result;
}

Continuity continuityOf(const Rendering& rendering, const Run& run) {
  constexpr std::size_t kLast = 10;  // images
  const auto truth = rendering.truth();
  const auto trajectory = run.trajectory();
  const auto live = run.liveTrajectory();
  if (trajectory.size() != truth.size() || live.size() != truth.size() || truth.size() < kLast) {
    throw std::runtime_error("not every image has a pose");
  }
  Continuity result;
  for (std::size_t i = 1; i < truth.size(); ++i) {
    const auto step = [i](const core::Trajectory& t) {
      return Eigen::Isometry3d(t[i - 1].T_map_cam.inverse() * t[i].T_map_cam);
    };
    result.step_m = std::max(result.step_m, (step(truth).inverse() * step(trajectory)).translation().norm());
  }
  for (std::size_t i = truth.size() - kLast; i < truth.size(); ++i) {
    const Eigen::Vector3d off_m = live[i].T_map_cam.translation() - trajectory[i].T_map_cam.translation();
    result.liveInEnd_m = std::max(result.liveInEnd_m, off_m.norm());
  }
  std::printf("from image to image off by up to %.1f mm; live poses in the end by up to %.1f mm\n", 1e3 * result.step_m,
              1e3 * result.liveInEnd_m);
  return result;
}

}  // namespace wardslam::gates
