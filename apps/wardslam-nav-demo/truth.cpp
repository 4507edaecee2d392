#include "truth.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <utility>

#include "wardslam/core/errors.h"
#include "wardslam/core/stamp_association.h"
#include "wardslam/evaluation/floor_plan_evaluation.h"
#include "wardslam/exchange/ros_map.h"
#include "wardslam/exchange/tum_trajectory.h"

namespace wardslam::nav_demo {
namespace fs = std::filesystem;
namespace {

std::vector<std::string> fieldsOf(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream text(line);
  for (std::string field; std::getline(text, field, ',');) fields.push_back(field);
  return fields;
}

std::vector<TrueThing> readThings(const fs::path& file) {
  std::ifstream in(file);
  if (!in) throw core::InputError(file.string() + ": cannot be read");
  std::string line;
  std::getline(in, line);
  std::map<std::string, std::size_t> column;
  for (const auto& name : fieldsOf(line)) column.emplace(name, column.size());
  std::vector<TrueThing> things;
  for (int number = 2; std::getline(in, line); ++number) {
    const auto fields = fieldsOf(line);
    try {
      const auto at = [&](const char* name) { return std::stod(fields.at(column.at(name))); };
      things.push_back(
          {fields.at(column.at("class_name")),
           Eigen::AlignedBox2d(Eigen::Vector2d(at("xmin"), at("ymin")), Eigen::Vector2d(at("xmax"), at("ymax")))});
    } catch (const std::logic_error&) {
      throw core::InputError(file.string() + ":" + std::to_string(number) +
                             ": columns class_name, xmin, ymin, xmax, ymax are needed");
    }
  }
  return things;
}

/// T_world_map, by where the camera was and how it looked at each keyframe: keyframes in a row along a straight way do
/// not tell by their places alone how the map lies about that way. Mean of rotations: the nearest to the sum of all.
Eigen::Isometry3d alignmentOf(const core::Trajectory& map, const core::Trajectory& world) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Eigen::Vector3d middle_map_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d middle_world_m = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < map.size(); ++i) {
    sum += world[i].T_map_cam.linear() * map[i].T_map_cam.linear().transpose();
    middle_map_m += map[i].T_map_cam.translation() / static_cast<double>(map.size());
    middle_world_m += world[i].T_map_cam.translation() / static_cast<double>(map.size());
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d U = svd.matrixU();
  if ((U * svd.matrixV().transpose()).determinant() < 0.0) U.col(2) *= -1.0;
  Eigen::Isometry3d T_world_map = Eigen::Isometry3d::Identity();
  T_world_map.linear() = U * svd.matrixV().transpose();
  T_world_map.translation() = middle_world_m - T_world_map.linear() * middle_map_m;
  return T_world_map;
}

core::Trajectory keyframesOf(const mapping::SemanticMap& map) {
  core::Trajectory trajectory;
  for (const auto& [id, keyframe] : map.keyframes) trajectory.push_back({keyframe.stamp_s, keyframe.T_map_cam});
  std::sort(trajectory.begin(), trajectory.end(), [](const auto& a, const auto& b) { return a.stamp_s < b.stamp_s; });
  return trajectory;
}

std::vector<double> stampsOf(const core::Trajectory& trajectory) {
  std::vector<double> stamps_s;
  for (const auto& pose : trajectory) stamps_s.push_back(pose.stamp_s);
  return stamps_s;
}

/// Keyframes and the true poses of the same times; those without one are left out.
std::pair<core::Trajectory, core::Trajectory> pairsOf(const core::Trajectory& keyframes,
                                                      const core::Trajectory& truth) {
  std::pair<core::Trajectory, core::Trajectory> pairs;
  for (const auto& [keyframe, pose] : core::associateByStamp(stampsOf(keyframes), stampsOf(truth))) {
    pairs.first.push_back(keyframes[keyframe]);
    pairs.second.push_back(truth[pose]);
  }
  return pairs;
}

double rmsDistance_m(const Eigen::Isometry3d& T_world_map, const core::Trajectory& map, const core::Trajectory& world) {
  double sum_m2 = 0.0;
  for (std::size_t i = 0; i < map.size(); ++i) {
    sum_m2 += (T_world_map * map[i].T_map_cam.translation() - world[i].T_map_cam.translation()).squaredNorm();
  }
  return std::sqrt(sum_m2 / static_cast<double>(map.size()));
}

}  // namespace

Truth readTruth(const fs::path& rawlog, const mapping::SemanticMap& map) {
  const fs::path stem = rawlog.parent_path() / rawlog.stem();
  const fs::path labels = stem.string() + "_labels";
  Truth truth;
  if (!fs::exists(labels / "floor.yaml")) {
    throw core::InputError((labels / "floor.yaml").string() +
                           ": is missing; rawlog-synth writes it beside the rawlog (make it anew)");
  }
  truth.floor = exchange::readRosMap(labels / "floor.yaml");
  truth.things = readThings(labels / "objects.csv");
  const auto groundTruth = exchange::readTumTrajectory(stem.string() + ".groundtruth.txt");
  const auto [keyframes, truePoses] = pairsOf(keyframesOf(map), groundTruth);
  if (keyframes.empty()) {
    throw core::InputError(stem.string() + ".groundtruth.txt: has no pose at the time of any keyframe of the map");
  }
  const Eigen::Isometry3d T_world_map = alignmentOf(keyframes, truePoses);
  truth.T_world_map = evaluation::onFloor(T_world_map);
  truth.mapError_m = rmsDistance_m(T_world_map, keyframes, truePoses);
  truth.source = "the scene that " + rawlog.filename().string() + " was rendered from";
  return truth;
}

Truth truthFromMap(const mapping::SemanticMap& map) {
  Truth truth;
  truth.floor = map.floorPlan;
  for (const auto& [id, object] : map.objects) {
    if (object.state == mapping::ObjectState::Gone) continue;
    truth.things.push_back(
        {map.labels.name(object.classId), Eigen::AlignedBox2d(Eigen::Vector2d(object.box_m.min().head<2>()),
                                                              Eigen::Vector2d(object.box_m.max().head<2>()))});
  }
  truth.source = "the map itself (no --truth)";
  return truth;
}

}  // namespace wardslam::nav_demo
