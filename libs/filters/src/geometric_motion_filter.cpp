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

constexpr int kBlur_px = 16;  // how far a region reaches beyond the mover it was grown from

cv::Mat square(int side_px) { return cv::getStructuringElement(cv::MORPH_RECT, {side_px, side_px}); }

/// Regions of which all but a small part is near to what is marked.
cv::Mat explainedRegions(const cv::Mat& moving, const cv::Mat& nearMarked) {
  constexpr double kMostExplained = 0.3;  // of the area of a region that stands for itself
  cv::Mat regions;
  cv::Mat statistics;
  cv::Mat centres;
  const int count = cv::connectedComponentsWithStats(moving, regions, statistics, centres);
  cv::Mat explained(moving.size(), CV_8UC1, cv::Scalar(0));
  for (int i = 1; i < count; ++i) {
    const cv::Mat region = regions == i;
    const double area_px = cv::countNonZero(region & nearMarked);
    if (area_px > kMostExplained * statistics.at<int>(i, cv::CC_STAT_AREA)) explained |= region;
  }
  return explained;
}

/// The moving regions without what marked pixels explain: around a mover with a mask, regions grown from points only
/// blur its outline. Of a region that goes on beyond that, as of somebody with a mask who pushes a thing without one,
/// what goes on stays, up to the rim of the mask.
cv::Mat unexplained(const cv::Mat& moving, const cv::Mat& marked) {
  if (marked.empty() || cv::countNonZero(marked) == 0) return moving;
  cv::Mat nearMarked;
  cv::dilate(marked, nearMarked, square(2 * kBlur_px + 1));
  nearMarked = nearMarked != 0;
  const cv::Mat explained = explainedRegions(moving, nearMarked);
  cv::Mat beyond = explained & ~nearMarked;
  cv::morphologyEx(beyond, beyond, cv::MORPH_OPEN, square(kBlur_px + 1));  // a blur that reaches farther is thin
  cv::dilate(beyond, beyond, square(2 * kBlur_px + 1));
  return (moving & ~explained) | (explained & beyond & (marked == 0));
}

}  // namespace

void GeometricMotionFilter::initialize(const core::ConfigNode& parameters, const FilterContext& /*context*/) {
  refuseMovedOptions(parameters);
  core::readOptions(parameters, options_);
  motion_.emplace(options_.motion);
}

void GeometricMotionFilter::begin(const core::Frame& frame) {
  following_ = std::async(std::launch::async, [this, frame] { motion_->follow(frame); });
}

void GeometricMotionFilter::apply(core::Frame& frame) {
  if (!following_.valid()) begin(frame);
  following_.get();
  motion_->judge(frame, markedPlaces(frame));
  if (motion_->isAtLoss()) ++frame.events["filters.motion_unknown"];
  const cv::Mat found = change::movingRegions(*motion_, frame.camera, frame.gray.size(), options_.regions);
  motion_->distrust(found);
  const cv::Mat moving = unexplained(found, core::dynamicPixels(frame));

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
