#include "wardslam/viewer/plan_raster.h"

#include <algorithm>

namespace wardslam::viewer {
namespace {

constexpr double kLongerSide_px = 1500.0;
constexpr double kMaxScale_px_per_m = 160.0;

Eigen::AlignedBox2d extentOf(const mapping::SemanticMap& map) {
  Eigen::AlignedBox2d extent;
  const auto& plan = map.floorPlan;
  if (!plan.cells.empty()) {
    extent.extend(plan.origin_m);
    extent.extend(plan.origin_m + plan.resolution_m * Eigen::Vector2d(plan.cells.cols, plan.cells.rows));
  }
  for (const auto& [id, keyframe] : map.keyframes) extent.extend(keyframe.T_map_cam.translation().head<2>());
  for (const auto& [id, object] : map.objects) {
    extent.extend(object.box_m.min().head<2>());
    extent.extend(object.box_m.max().head<2>());
  }
  if (extent.isEmpty()) extent.extend(Eigen::Vector2d::Zero());
  constexpr double kMargin_m = 0.3;
  extent.extend(extent.min() - Eigen::Vector2d::Constant(kMargin_m));
  extent.extend(extent.max() + Eigen::Vector2d::Constant(kMargin_m));
  return extent;
}

}  // namespace

PlanRaster::PlanRaster(const mapping::SemanticMap& map) : extent_(extentOf(map)) {
  scale_px_per_m_ = std::min(kMaxScale_px_per_m, kLongerSide_px / std::max(1.0, extent_.sizes().maxCoeff()));
}

cv::Size PlanRaster::size() const {
  return {std::max(1, toPixels(extent_.sizes().x())), std::max(1, toPixels(extent_.sizes().y()))};
}

cv::Point PlanRaster::at(const Eigen::Vector2d& p_map_m) const {
  return {toPixels(p_map_m.x() - extent_.min().x()), toPixels(extent_.max().y() - p_map_m.y())};
}

}  // namespace wardslam::viewer
