#include "wardslam/filters/geometric_motion_filter.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "wardslam/core/annotation.h"

namespace wardslam::filters {

IMPLEMENTS_MRPT_OBJECT(GeometricMotionFilter, ObservationFilter, wardslam::filters)

namespace {

bool isDynamic(const core::Keypoint& keypoint) { return keypoint.motion == core::Motion::Dynamic; }

bool isIn(const cv::Mat& mask, const cv::Point2f& raw_px) {
  return mask.at<std::uint8_t>(std::clamp(cvRound(raw_px.y), 0, mask.rows - 1),
                               std::clamp(cvRound(raw_px.x), 0, mask.cols - 1)) != 0;
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

/// Adds to what earlier filters wrote.
void annotateDynamic(core::Frame& frame, const cv::Mat& moving) {
  const auto& range = frame.observation->rangeImage;
  if (range.rows() != moving.rows || range.cols() != moving.cols) {
    ++frame.events["filters.annotation_size"];
    return;
  }
  cv::Mat bits = core::annotationOf(*frame.observation);
  if (bits.size() != moving.size()) bits = cv::Mat(moving.size(), CV_8UC1, cv::Scalar(0));
  cv::bitwise_or(bits, cv::Scalar(core::bitOf(core::PixelLabel::Dynamic)), bits, moving);
  core::annotate(*frame.observation, bits);
}

}  // namespace

void GeometricMotionFilter::initialize(const core::ConfigNode& parameters, const FilterContext& /*context*/) {
  core::readOptions(parameters, options_);
  motion_.emplace(options_.motion);
}

void GeometricMotionFilter::apply(core::Frame& frame) {
  motion_->update(frame, markedPlaces(frame));
  if (motion_->isAtLoss()) ++frame.events["filters.motion_unknown"];
  const cv::Mat moving = movingRegions(*motion_, frame.camera, frame.gray.size(), options_.regions);
  motion_->distrust(moving);

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
  core::addMayMove(frame, moving);
  if (options_.annotate && frame.observation) annotateDynamic(frame, moving);
}

std::string GeometricMotionFilter::parameters(int indent) const { return core::writeOptions(options_, indent); }

}  // namespace wardslam::filters
