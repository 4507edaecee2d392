#include "motion_annotation.h"

#include "wardslam/core/annotation.h"

namespace wardslam::filters {
namespace {

using core::bitOf;
using core::PixelLabel;

cv::Mat bitsOfClasses(const knowledge::MotionRules& rules) {
  cv::Mat bits(1, 256, CV_8UC1, cv::Scalar(0));
  for (int c = 1; c < 256; ++c) {
    const auto id = static_cast<core::ClassId>(c);
    auto& entry = bits.at<std::uint8_t>(c);
    entry = rules.isMoving(id) ? bitOf(PixelLabel::Person) : bitOf(PixelLabel::Thing);
    if (rules.isMovable(id)) entry = static_cast<std::uint8_t>(entry | bitOf(PixelLabel::Movable));
  }
  return bits;
}

}  // namespace

cv::Mat motionLabels(const core::Segmentation& segmentation, const cv::Mat& dynamicMask,
                     const knowledge::MotionRules& rules) {
  cv::Mat labels;
  cv::LUT(segmentation.classIds, bitsOfClasses(rules), labels);
  cv::bitwise_or(labels, cv::Scalar(bitOf(PixelLabel::Dynamic)), labels, dynamicMask);
  return labels;
}

}  // namespace wardslam::filters
