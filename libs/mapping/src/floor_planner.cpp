#include "wardslam/mapping/floor_planner.h"

#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <string>

#include "free_fan.h"
#include "ground_surface.h"
#include "wardslam/core/errors.h"
#include "wardslam/mapping/cloud_in_map.h"

namespace wardslam::mapping {
namespace {

constexpr double kMaxGap_rad = 2.5 * kFanDirection_rad;  // a hole in the depth image wider than this stays unknown
constexpr double kMargin_m = 0.5;
constexpr double kMaxCells = 4e8;
constexpr int kSubcellBits = 4;  // of cv::fillConvexPoly

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
cv::Mat countObstacles(const SemanticMap& map, const GroundSurface& ground, const FloorPlan& plan,
                       const FloorPlanOptions& options) {
  cv::Mat counts(plan.cells.size(), CV_32SC1, cv::Scalar(0));
  forEachCloudPoint(map, [&](const Eigen::Vector3f& p_map_m, const SemanticPoint& /*point*/) {
    const double height_m = ground.heightOver_m(p_map_m);
    if (height_m < options.min_height_m || height_m > options.max_height_m) return;
    const Eigen::Vector2d cell = toCells(plan, p_map_m.head<2>().cast<double>());
    ++counts.at<int>(static_cast<int>(std::lround(cell.y())), static_cast<int>(std::lround(cell.x())));
  });
  return counts;
}

}  // namespace

FloorPlan drawFloorPlan(const SemanticMap& map, const FloorPlanOptions& options) {
  const auto extent = extentOf(map);
  if (extent.isEmpty()) return {};
  FloorPlan plan = emptyPlan(extent, options.resolution_m);
  const GroundSurface ground(map);
  for (const auto& [id, keyframe] : map.keyframes) {
    if (ground.carries(id)) drawFree(keyframe, plan);
  }
  plan.cells.setTo(FloorPlan::kOccupied, countObstacles(map, ground, plan, options) >= options.min_points);
  return plan;
}

}  // namespace wardslam::mapping
