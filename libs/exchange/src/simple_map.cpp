#include "wardslam/exchange/simple_map.h"

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "wardslam/core/atomic_file.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/exchange/map_export.h"

namespace wardslam::exchange {
namespace {

using mapping::FloorPlan;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservation3DRangeScan;

constexpr int kDirections = 720;
constexpr double kStep_rad = 2.0 * M_PI / kDirections;
constexpr double kFarthest_m = 10.0;
constexpr double kScanHeight_m = 0.3;

/// Upright where the camera is, x ahead as far as that can be.
struct LevelPose {
  explicit LevelPose(const Eigen::Isometry3d& T_map_cam) : p_map_m(T_map_cam.translation()) {
    const Eigen::Vector3d ahead = T_map_cam.linear().col(2);
    yaw_rad = std::atan2(ahead.y(), ahead.x());
  }

  [[nodiscard]] Eigen::Isometry3d T_map_level() const {
    return Eigen::Translation3d(p_map_m) * Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ());
  }

  Eigen::Vector3d p_map_m;
  double yaw_rad = 0.0;
};

CObservation3DRangeScan::Ptr pointsOf(const mapping::SemanticCloudTile& tile, const Eigen::Isometry3d& T_level_cam) {
  auto scan = CObservation3DRangeScan::Create();
  scan->sensorLabel = "RGBD";
  scan->hasPoints3D = true;
  scan->maxRange = 0.0F;
  const Eigen::Isometry3f T_cam = T_level_cam.cast<float>();
  scan->resizePoints3DVectors(tile.points.size());  // indices of pixels, too, without which it cannot be written
  for (std::size_t i = 0; i < tile.points.size(); ++i) {
    const Eigen::Vector3f p_m = T_cam * tile.points[i].p_cam_m;
    scan->points3D_x[i] = p_m.x();
    scan->points3D_y[i] = p_m.y();
    scan->points3D_z[i] = p_m.z();
    scan->points3D_idxs_x[i] = scan->points3D_idxs_y[i] = 0;
    scan->maxRange = std::max(scan->maxRange, p_m.norm());
  }
  return scan;
}

/// How far it is from a place to the first occupied cell in a direction; nothing where floor comes first that nobody
/// knows. Half a cell at a time.
std::optional<double> distanceToObstacle_m(const FloorPlan& plan, const Eigen::Vector2d& from_m, double bearing_rad) {
  const Eigen::Vector2d direction(std::cos(bearing_rad), std::sin(bearing_rad));
  for (double range_m = 0.0; range_m < kFarthest_m; range_m += plan.resolution_m / 2) {
    const Eigen::Vector2d cell = (from_m + range_m * direction - plan.origin_m) / plan.resolution_m;
    const cv::Point at(static_cast<int>(std::floor(cell.x())), static_cast<int>(std::floor(cell.y())));
    if (!cv::Rect({}, plan.cells.size()).contains(at)) return std::nullopt;
    const unsigned char is = plan.cells.at<unsigned char>(at);
    if (is == FloorPlan::kOccupied) return range_m;
    if (is == FloorPlan::kUnknown) return std::nullopt;
  }
  return std::nullopt;
}

/// A scan of neighbouring directions, counted from ahead to the left.
CObservation2DRangeScan::Ptr scanOf(const std::vector<float>& ranges_m, int firstDirection, double height_m) {
  auto scan = CObservation2DRangeScan::Create();
  scan->sensorLabel = "RGBD_SCAN";
  scan->rightToLeft = true;
  scan->maxRange = static_cast<float>(kFarthest_m);
  const double aperture_rad = kStep_rad * static_cast<double>(ranges_m.size() - 1);
  scan->aperture = static_cast<float>(aperture_rad);
  const double middle_rad = kStep_rad * firstDirection + aperture_rad / 2;
  scan->setSensorPose(mrpt::poses::CPose3D(0.0, 0.0, height_m, middle_rad, 0.0, 0.0));
  scan->resizeScan(ranges_m.size());
  for (std::size_t i = 0; i < ranges_m.size(); ++i) {
    scan->setScanRange(i, ranges_m[i]);
    scan->setScanRangeValidity(i, true);
  }
  return scan;
}

/// A direction in which nothing is known to stand cannot be said: MRPT takes rays without an end for free up to half
/// the distance it inserts at most, whatever the sensor reaches.
void addScans(const FloorPlan& plan, const LevelPose& robot, mrpt::Clock::time_point stamp,
              mrpt::obs::CSensoryFrame& frame) {
  std::vector<float> run_m;
  for (int direction = 0; direction <= kDirections; ++direction) {
    const auto range_m = direction < kDirections ? distanceToObstacle_m(plan, robot.p_map_m.head<2>(),
                                                                        robot.yaw_rad + kStep_rad * direction)
                                                 : std::nullopt;
    if (range_m) {
      run_m.push_back(static_cast<float>(*range_m));
      continue;
    }
    if (run_m.size() > 1) {
      const int first = direction - static_cast<int>(run_m.size());
      const auto scan = scanOf(run_m, first, kScanHeight_m - robot.p_map_m.z());
      scan->timestamp = stamp;
      frame.insert(scan);
    }
    run_m.clear();
  }
}

}  // namespace

mrpt::maps::CSimpleMap toSimpleMap(const mapping::SemanticMap& map) {
  mrpt::maps::CSimpleMap simple;
  for (const auto& [id, keyframe] : map.keyframes) {
    // The robot stands level, as COccupancyGridMap2D takes no scan that is tilted against its robot, and where the
    // camera is, as COctoMap looks over the place of a 3D scan on its robot (findings/).
    const LevelPose robot(keyframe.T_map_cam);
    const Eigen::Isometry3d T_map_level = robot.T_map_level();
    auto frame = mrpt::obs::CSensoryFrame::Create();
    const auto tile = map.cloud.find(id);
    if (tile != map.cloud.end()) {
      const auto points = pointsOf(tile->second, T_map_level.inverse() * keyframe.T_map_cam);
      points->timestamp = core::toMrptTime(keyframe.stamp_s);
      frame->insert(points);
    }
    if (!map.floorPlan.cells.empty()) addScans(map.floorPlan, robot, core::toMrptTime(keyframe.stamp_s), *frame);
    auto pose = mrpt::poses::CPose3DPDFGaussian::Create(core::toMrpt(T_map_level));
    pose->cov.setDiagonal(6, kKeyframePoseSigma * kKeyframePoseSigma);
    simple.insert(mrpt::poses::CPose3DPDF::Ptr(pose), frame);
  }
  return simple;
}

void exportSimpleMap(const mapping::SemanticMap& map, const std::filesystem::path& file) {
  const auto simple = toSimpleMap(map);
  core::replaceAtomically(file, [&simple](const std::filesystem::path& partial) {
    if (!simple.saveToFile(partial.string())) throw core::InputError(partial.string() + ": cannot be written");
  });
}

}  // namespace wardslam::exchange
