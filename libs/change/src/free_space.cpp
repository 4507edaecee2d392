#include "free_space.h"

#include <limits>
#include <opencv2/imgproc.hpp>

namespace wardslam::change {
namespace {

constexpr float kNoDepth = std::numeric_limits<float>::max();

cv::Mat sampled(const cv::Mat& depth_m) {
  cv::Mat small;
  cv::resize(depth_m, small, depth_m.size() / DepthGrid::kStep_px, 0, 0, cv::INTER_NEAREST);
  return small;
}

/// Raw pixel of the full image that cv::INTER_NEAREST takes for this one.
cv::Point2f fullPixel(int column, int row) {
  return {static_cast<float>(column * DepthGrid::kStep_px), static_cast<float>(row * DepthGrid::kStep_px)};
}

cv::Mat raysOf(const cv::Size& size, const core::CameraModel& camera) {
  std::vector<cv::Point2f> pixels;
  for (int row = 0; row < size.height; ++row) {
    for (int column = 0; column < size.width; ++column) pixels.push_back(fullPixel(column, row));
  }
  cv::Mat rays(size, CV_32FC2);
  auto* ray = rays.ptr<cv::Vec2f>();
  for (const cv::Point2f& px : camera.undistort(pixels)) {
    *ray++ = {(px.x - static_cast<float>(camera.cx_px)) / static_cast<float>(camera.fx_px),
              (px.y - static_cast<float>(camera.cy_px)) / static_cast<float>(camera.fy_px)};
  }
  return rays;
}

}  // namespace

DepthGrid::DepthGrid(const cv::Mat& depth_m, const core::CameraModel& camera, const DepthGrid* before)
    : camera_(camera), depth_m_(sampled(depth_m)) {
  const cv::Mat around = cv::getStructuringElement(cv::MORPH_RECT, {5, 5});
  cv::Mat filled = depth_m_.clone();
  filled.setTo(kNoDepth, depth_m_ <= 0);
  cv::erode(filled, nearest_m_, around);
  cv::dilate(depth_m_, farthest_m_, around);
  const bool isSameCamera = before != nullptr && before->size() == size() && before->camera_ == camera;
  rays_ = isSameCamera ? before->rays_ : raysOf(size(), camera);
}

cv::Mat DepthGrid::compareWith(const DepthGrid& past, const Eigen::Isometry3d& T_past_this) const {
  cv::Mat result(size(), CV_8UC1, cv::Scalar(static_cast<int>(Seen::Unknown)));
  for (int row = 0; row < result.rows; ++row) {
    const auto* depth = depth_m_.ptr<float>(row);
    const auto* rays = rays_.ptr<cv::Vec2f>(row);
    auto* out = result.ptr<std::uint8_t>(row);
    for (int column = 0; column < result.cols; ++column) {
      if (depth[column] <= 0) continue;
      const auto z = static_cast<double>(depth[column]);
      const Eigen::Vector3d p_this(static_cast<double>(rays[column][0]) * z, static_cast<double>(rays[column][1]) * z,
                                   z);
      out[column] = static_cast<std::uint8_t>(past.look(T_past_this * p_this, camera_.depthNoise));
    }
  }
  return result;
}

Seen DepthGrid::look(const Eigen::Vector3d& p_m, const core::DepthNoise& ofPoint) const {
  const auto full_px = pixelOf(p_m, camera_);
  if (!full_px) return Seen::Unknown;
  const Eigen::Vector2d px = *full_px / kStep_px;
  const cv::Point at(cvRound(px.x()), cvRound(px.y()));
  if (!cv::Rect({}, size()).contains(at) || depth_m_.at<float>(at) <= 0) return Seen::Unknown;
  const DepthRange shown{static_cast<double>(nearest_m_.at<float>(at)), static_cast<double>(farthest_m_.at<float>(at))};
  return seenAt(p_m.z(), shown, ofPoint, camera_.depthNoise);
}

}  // namespace wardslam::change
