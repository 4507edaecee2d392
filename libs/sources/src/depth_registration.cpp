#include "depth_registration.h"

#include <algorithm>
#include <cmath>

#include "wardslam/core/view_rays.h"

namespace wardslam::sources {
namespace {

/// Nearer than this a depth pixel would cover much of the image, and no such camera measures there.
constexpr double kMinDepth_m = 0.05;

/// Neighbouring squares overlap by a tenth, else slanted surfaces would show cracks.
constexpr double kOverlap = 1.1;

}  // namespace

DepthRegistration::DepthRegistration(const RgbdRig& rig) : rig_(rig), depthRays_(core::viewRays(rig.depth)) {}

cv::Mat DepthRegistration::apply(const cv::Mat& depth_m) const {
  CV_Assert(depth_m.type() == CV_32FC1 && depth_m.size() == depthRays_.size());
  cv::Mat registered_m = cv::Mat::zeros(rig_.color.height_px, rig_.color.width_px, CV_32FC1);
  const double magnification = std::max(rig_.color.fx_px / rig_.depth.fx_px, rig_.color.fy_px / rig_.depth.fy_px);
  for (int v = 0; v < depth_m.rows; ++v) {
    const auto* ray = depthRays_.ptr<cv::Vec2f>(v);
    const auto* row_m = depth_m.ptr<float>(v);
    for (int u = 0; u < depth_m.cols; ++u) {
      if (row_m[u] <= 0.0F) continue;
      const double z_m = row_m[u];
      const Eigen::Vector3d p_color = rig_.T_color_depth * Eigen::Vector3d(ray[u][0] * z_m, ray[u][1] * z_m, z_m);
      if (p_color.z() < kMinDepth_m) continue;
      // A square of less than one pixel would fall between the colour pixels.
      const double width_px = std::max(1.0, kOverlap * magnification * z_m / p_color.z());
      splat(p_color, 0.5 * width_px, registered_m);
    }
  }
  return registered_m;
}

void DepthRegistration::splat(const Eigen::Vector3d& p_color, double halfWidth_px, cv::Mat& registered_m) const {
  const Eigen::Vector2d center_px = rig_.color.projectDistorted(p_color);
  if (!(std::abs(center_px.x()) < 1e6 && std::abs(center_px.y()) < 1e6)) return;  // the lens model ran away
  const auto first = [&](double c_px) { return std::max(0, static_cast<int>(std::ceil(c_px - halfWidth_px))); };
  const auto last = [&](double c_px, int size_px) {
    return std::min(size_px, static_cast<int>(std::ceil(c_px + halfWidth_px)));
  };
  const auto z_m = static_cast<float>(p_color.z());
  for (int v = first(center_px.y()); v < last(center_px.y(), registered_m.rows); ++v) {
    auto* row_m = registered_m.ptr<float>(v);
    for (int u = first(center_px.x()); u < last(center_px.x(), registered_m.cols); ++u) {
      if (row_m[u] == 0.0F || z_m < row_m[u]) row_m[u] = z_m;
    }
  }
}

}  // namespace wardslam::sources
