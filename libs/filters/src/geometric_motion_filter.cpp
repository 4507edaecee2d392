#include "geometric_motion_filter.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "moved_options.h"
#include "wardslam/core/nearest_pixel.h"

namespace wardslam::filters {

IMPLEMENTS_MRPT_OBJECT(GeometricMotionFilter, ObservationFilter, wardslam::filters)

namespace {

bool isDynamic(const core::Keypoint& keypoint) { return keypoint.motion == core::Motion::Dynamic; }

bool isIn(const cv::Mat& mask, const cv::Point2f& raw_px) {
  return mask.at<std::uint8_t>(core::nearestPixel(raw_px, mask.size())) != 0;
}

/// Where earlier filters marked key points; empty where they marked none.
cv::Mat markedPlaces(const core::Frame& frame) {
  cv::Mat places;
  for (const core::Keypoint& keypoint : frame.features.keypoints) {
    if (!isDynamic(keypoint)) continue;
    if (places.empty()) places = cv::Mat(frame.gray.size(), CV_8UC1, cv::Scalar(0));
    cv::circle(places, keypoint.raw_px, 0, 255, cv::FILLED);
  }
  return places;
}

/// Where motion is that earlier filters have marked: around a mover with a mask, points and surfaces only blur its
/// outline.
cv::Mat explainedMotion(const core::Frame& frame) {
  constexpr int kBlur_px = 16;  // how far that reaches
  const cv::Mat marked = core::dynamicPixels(frame);
  cv::Mat explained(frame.gray.size(), CV_8UC1, cv::Scalar(0));
  if (!marked.empty()) cv::dilate(marked, explained, cv::Mat::ones(2 * kBlur_px + 1, 2 * kBlur_px + 1, CV_8UC1));
  return explained;
}

}  // namespace

void GeometricMotionFilter::initialize(const core::ConfigNode& parameters, const FilterContext& /*context*/) {
  refuseMovedOptions(parameters);
  core::readOptions(parameters, options_);
  motion_.emplace(options_.motion);
}

void GeometricMotionFilter::begin(const core::Frame& frame) {
  following_.start([this, frame] { motion_->follow(frame); });
}

void GeometricMotionFilter::apply(core::Frame& frame) {
  if (!following_.isStarted()) begin(frame);
  following_.take();
  motion_->judge(frame, markedPlaces(frame));
  if (motion_->isAtLoss()) ++frame.events["filters.motion_unknown"];
  const cv::Mat explained = explainedMotion(frame);
  const cv::Mat moving = change::movingRegions(*motion_, frame.camera, explained, options_.regions);
  motion_->distrust(moving | explained);

  auto& keypoints = frame.features.keypoints;
  const auto stays = std::count_if(keypoints.begin(), keypoints.end(),
                                   [&](const auto& k) { return !isDynamic(k) && !isIn(moving, k.raw_px); });
  if (static_cast<double>(stays) < options_.min_kept * static_cast<double>(keypoints.size())) {
    ++frame.events["filters.motion_everywhere"];
    return;
  }
  for (core::Keypoint& keypoint : keypoints) {
    if (isIn(moving, keypoint.raw_px)) keypoint.motion = core::Motion::Dynamic;
  }
  core::addDynamic(frame, moving);
}

std::string GeometricMotionFilter::parameters(int indent) const { return core::writeOptions(options_, indent); }

}  // namespace wardslam::filters
