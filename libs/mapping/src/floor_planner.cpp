#include "wardslam/mapping/floor_planner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <string>

#include "wardslam/core/errors.h"
#include "wardslam/mapping/cloud_in_map.h"
#include "wardslam/mapping/depth_points.h"

namespace wardslam::mapping {
namespace {

constexpr int kStep_px = 4;
constexpr double kDirection_rad = 0.5 * M_PI / 180.0;
constexpr double kMaxGap_rad = 2.5 * kDirection_rad;  // a hole in the depth image wider than this stays unknown
constexpr int kObstaclePoints = 3;                    // fewer in one direction are stray measurements
constexpr double kMargin_m = 0.5;
constexpr double kMaxCells = 4e8;
constexpr int kSubcellBits = 4;  // of cv::fillConvexPoly

/// What one direction shows.
struct Direction {
  std::array<double, kObstaclePoints> nearestObstacles_m{};  ///< Ascending.
  double farthest_m = 0.0;                                   ///< Of all that was measured.

  Direction() { nearestObstacles_m.fill(std::numeric_limits<double>::infinity()); }

  void addObstacle(double range_m) {
    if (range_m >= nearestObstacles_m.back()) return;
    nearestObstacles_m.back() = range_m;
    std::sort(nearestObstacles_m.begin(), nearestObstacles_m.end());
  }
  [[nodiscard]] double free_m() const { return std::min(farthest_m, nearestObstacles_m.back()); }
};

/// Directions over a half circle around where the camera looks.
class Panorama {
 public:
  explicit Panorama(const Eigen::Isometry3d& T_map_cam)
      : directions_(static_cast<std::size_t>(std::lround(M_PI / kDirection_rad))) {
    // A camera that looks straight down has no heading but the one of its image's upper edge.
    const Eigen::Vector3d ahead = T_map_cam.linear() * Eigen::Vector3d(0.0, -0.1, 1.0);
    heading_rad_ = std::atan2(ahead.y(), ahead.x());
  }

  Direction* towards(const Eigen::Vector2d& offset_m) {
    const double bearing_rad = std::remainder(std::atan2(offset_m.y(), offset_m.x()) - heading_rad_, 2.0 * M_PI);
    const double index = (M_PI / 2.0 - bearing_rad) / kDirection_rad;
    if (index < 0.0 || index >= static_cast<double>(directions_.size())) return nullptr;
    return &directions_[static_cast<std::size_t>(index)];
  }

  /// From left to right.
  [[nodiscard]] std::vector<Eigen::Vector2d> freeOffsets_m(double maxRange_m) const {
    std::vector<Eigen::Vector2d> offsets;
    for (std::size_t i = 0; i < directions_.size(); ++i) {
      const double range_m = std::min(directions_[i].free_m(), maxRange_m);
      if (range_m <= 0.0) continue;
      const double angle_rad = heading_rad_ + M_PI / 2.0 - (static_cast<double>(i) + 0.5) * kDirection_rad;
      offsets.emplace_back(range_m * std::cos(angle_rad), range_m * std::sin(angle_rad));
    }
    return offsets;
  }

 private:
  double heading_rad_ = 0.0;
  std::vector<Direction> directions_;
};

/// The rectangle of the x-y plane that holds everything to be drawn.
Eigen::AlignedBox2d extentOf(const SemanticMap& map) {
  Eigen::AlignedBox2d extent;
  for (const auto& [id, keyframe] : map.keyframes) {
    extent.extend(keyframe.T_map_cam.translation().head<2>());
    for (const auto& end : keyframe.freeFan_cam_m) {
      extent.extend((keyframe.T_map_cam * end.cast<double>()).head<2>());
    }
  }
  forEachCloudPoint(map, [&extent](const Eigen::Vector3f& p_map_m, const SemanticPoint& /*point*/) {
    extent.extend(p_map_m.head<2>().cast<double>());
  });
  return extent;
}

FloorPlan emptyPlan(const Eigen::AlignedBox2d& extent, double resolution_m) {
  const Eigen::Vector2d size_m = extent.sizes() + Eigen::Vector2d::Constant(2.0 * kMargin_m);
  const Eigen::Vector2d cells = (size_m / resolution_m).array().ceil();
  if (!(cells.x() * cells.y() <= kMaxCells)) {
    throw core::InputError("the map is " + std::to_string(std::lround(size_m.x())) + " m by " +
                           std::to_string(std::lround(size_m.y())) +
                           " m, too large for its floor plan; choose a larger mapping.floor_plan.resolution_m");
  }
  FloorPlan plan;
  plan.resolution_m = resolution_m;
  // On a common raster, so that the plans of two maps in one frame have the same cells.
  const Eigen::Vector2d corner = extent.min() - Eigen::Vector2d::Constant(kMargin_m);
  plan.origin_m = (corner / resolution_m).array().floor() * resolution_m;
  plan.cells = cv::Mat(static_cast<int>(cells.y()) + 1, static_cast<int>(cells.x()) + 1, CV_8UC1,
                       cv::Scalar(FloorPlan::kUnknown));
  return plan;
}

/// In cells; (0, 0) is the centre of the first.
Eigen::Vector2d toCells(const FloorPlan& plan, const Eigen::Vector2d& p_map_m) {
  return (p_map_m - plan.origin_m) / plan.resolution_m - Eigen::Vector2d::Constant(0.5);
}

cv::Point toSubcells(const FloorPlan& plan, const Eigen::Vector2d& p_map_m) {
  const Eigen::Vector2d cells = toCells(plan, p_map_m) * (1 << kSubcellBits);
  return {static_cast<int>(std::lround(cells.x())), static_cast<int>(std::lround(cells.y()))};
}

void drawFree(const MappedKeyframe& keyframe, FloorPlan& plan) {
  const Eigen::Vector2d eye = keyframe.T_map_cam.translation().head<2>();
  std::optional<Eigen::Vector2d> previous;
  for (const auto& end_cam : keyframe.freeFan_cam_m) {
    const Eigen::Vector2d end = (keyframe.T_map_cam * end_cam.cast<double>()).head<2>();
    if (previous) {
      const Eigen::Vector2d a = *previous - eye;
      const Eigen::Vector2d b = end - eye;
      const double gap_rad = std::atan2(std::abs(a.x() * b.y() - a.y() * b.x()), a.dot(b));
      if (gap_rad <= kMaxGap_rad) {
        const std::array<cv::Point, 3> corners{toSubcells(plan, eye), toSubcells(plan, *previous),
                                               toSubcells(plan, end)};
        cv::fillConvexPoly(plan.cells, corners.data(), 3, cv::Scalar(FloorPlan::kFree), cv::LINE_8, kSubcellBits);
      }
    }
    previous = end;
  }
}

/// Points of the cloud in a robot's way, per cell.
cv::Mat countObstacles(const SemanticMap& map, const FloorPlan& plan, const FloorPlanOptions& options) {
  cv::Mat counts(plan.cells.size(), CV_32SC1, cv::Scalar(0));
  forEachCloudPoint(map, [&](const Eigen::Vector3f& p_map_m, const SemanticPoint& /*point*/) {
    const auto height_m = static_cast<double>(p_map_m.z());
    if (height_m < options.min_height_m || height_m > options.max_height_m) return;
    const Eigen::Vector2d cell = toCells(plan, p_map_m.head<2>().cast<double>());
    ++counts.at<int>(static_cast<int>(std::lround(cell.y())), static_cast<int>(std::lround(cell.x())));
  });
  return counts;
}

}  // namespace

std::vector<Eigen::Vector3f> freeFan(const cv::Mat& depth_m, const core::CameraModel& camera,
                                     const Eigen::Isometry3d& T_map_cam, const FloorPlanOptions& options) {
  Panorama panorama(T_map_cam);
  for (const DepthPoint& point : depthPoints(depth_m, camera, kStep_px)) {
    const Eigen::Vector3d offset_m = T_map_cam.linear() * point.p_cam_m;
    const double height_m = T_map_cam.translation().z() + offset_m.z();
    Direction* const direction = panorama.towards(offset_m.head<2>());
    if (direction == nullptr || height_m > options.max_height_m) continue;
    const double range_m = offset_m.head<2>().norm();
    direction->farthest_m = std::max(direction->farthest_m, range_m);
    if (height_m >= options.min_height_m) direction->addObstacle(range_m);
  }
  std::vector<Eigen::Vector3f> fan_cam_m;
  for (const Eigen::Vector2d& offset_m : panorama.freeOffsets_m(options.max_range_m)) {
    const Eigen::Vector3d atEyeLevel_m(offset_m.x(), offset_m.y(), 0.0);
    fan_cam_m.push_back((T_map_cam.linear().transpose() * atEyeLevel_m).cast<float>());
  }
  return fan_cam_m;
}

FloorPlan drawFloorPlan(const SemanticMap& map, const FloorPlanOptions& options) {
  const auto extent = extentOf(map);
  if (extent.isEmpty()) return {};
  FloorPlan plan = emptyPlan(extent, options.resolution_m);
  for (const auto& [id, keyframe] : map.keyframes) drawFree(keyframe, plan);
  plan.cells.setTo(FloorPlan::kOccupied, countObstacles(map, plan, options) >= options.min_points);
  return plan;
}

}  // namespace wardslam::mapping
