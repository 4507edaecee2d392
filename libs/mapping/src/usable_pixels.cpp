#include "usable_pixels.h"

#include <opencv2/imgproc.hpp>

namespace wardslam::mapping {
namespace {

/// Points are taken for seen through only when everything so near (px) to them is farther away.
constexpr int kSeenThroughMargin_px = 2;

constexpr float kDisparityStep_m = 348.0F;  // depth times disparity of a Kinect; one disparity step is z² / 348 m
constexpr float kSlope_m = 0.02F;
constexpr int kFlierReach_px = 2;

cv::Mat movingPixels(const View& view, const knowledge::ClassSet& movingClasses, int margin_px) {
  cv::Mat moving = view.mayMove.empty() ? cv::Mat(view.depth_m.size(), CV_8UC1, cv::Scalar(0)) : view.mayMove.clone();
  if (!view.segmentation.empty()) {
    cv::Mat table(1, 256, CV_8UC1);
    for (int c = 0; c < 256; ++c) table.at<std::uint8_t>(c) = movingClasses[static_cast<std::size_t>(c)] ? 255 : 0;
    cv::Mat byClass;
    cv::LUT(view.segmentation.classIds, table, byClass);
    moving |= byClass;
  }
  if (margin_px == 0) return moving;
  const int side = 2 * margin_px + 1;
  cv::dilate(moving, moving, cv::getStructuringElement(cv::MORPH_RECT, {side, side}));
  return moving;
}

/// Pixels that have both something clearly nearer and something clearly farther beside them.
cv::Mat fliers(const cv::Mat& depth_m, const core::DepthNoise& noise) {
  const int side = 2 * kFlierReach_px + 1;
  const cv::Mat window = cv::getStructuringElement(cv::MORPH_RECT, {side, side});
  cv::Mat farthest;
  cv::dilate(depth_m, farthest, window);
  cv::Mat nearest = depth_m.clone();
  nearest.setTo(std::numeric_limits<float>::max(), depth_m <= 0);
  cv::erode(nearest, nearest, window);
  cv::Mat result(depth_m.size(), CV_8UC1, cv::Scalar(0));
  for (int v = 0; v < depth_m.rows; ++v) {
    for (int u = 0; u < depth_m.cols; ++u) {
      const float z_m = depth_m.at<float>(v, u);
      if (z_m <= 0) continue;
      const float step_m = edgeStep_m(z_m, noise);
      if (farthest.at<float>(v, u) - z_m > step_m && z_m - nearest.at<float>(v, u) > step_m) {
        result.at<std::uint8_t>(v, u) = 255;
      }
    }
  }
  return result;
}

}  // namespace

float edgeStep_m(float z_m, const core::DepthNoise& noise) {
  return kSlope_m + 3.0F * static_cast<float>(noise.sigma_m(static_cast<double>(z_m))) + z_m * z_m / kDisparityStep_m;
}

cv::Mat usablePixels(const View& view, const knowledge::ClassSet& moving, const CloudOptions& options) {
  cv::Mat usable = (view.depth_m > 0) & (view.depth_m <= options.max_range_m);
  usable.setTo(0, movingPixels(view, moving, options.mover_margin_px));
  usable.setTo(0, fliers(view.depth_m, view.camera.depthNoise));
  return usable;
}

cv::Mat nearestAround(const cv::Mat& depth_m) {
  const int side = 2 * kSeenThroughMargin_px + 1;
  cv::Mat nearest;  // holes stay holes, and spread: what is not measured is not seen through
  cv::erode(depth_m, nearest, cv::getStructuringElement(cv::MORPH_RECT, {side, side}));
  return nearest;
}

}  // namespace wardslam::mapping
