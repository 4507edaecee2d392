#include "wardslam/filters/motion_annotation.h"

#include <algorithm>

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

/// Asks at a grid of its pixels: as true as asking at all of them, and cheap.
bool isMostlyDynamic(const cv::Mat& mask, cv::Point origin, DynamicTest& test) {
  const int step = std::clamp(std::min(mask.rows, mask.cols) / 8, 1, 8);
  int asked = 0;
  int dynamic = 0;
  for (int y = step / 2; y < mask.rows; y += step) {
    for (int x = step / 2; x < mask.cols; x += step) {
      if (mask.at<std::uint8_t>(y, x) == 0) continue;
      ++asked;
      if (test.at(origin + cv::Point(x, y)) == core::Motion::Dynamic) ++dynamic;
    }
  }
  return asked > 0 && 2 * dynamic >= asked;
}

}  // namespace

cv::Mat motionLabels(const core::Segmentation& segmentation, const cv::Mat& movingMask,
                     const knowledge::MotionRules& rules, DynamicTest& test) {
  const cv::Scalar dynamicBit(bitOf(PixelLabel::Dynamic));
  cv::Mat labels;
  cv::LUT(segmentation.classIds, bitsOfClasses(rules), labels);
  cv::bitwise_or(labels, dynamicBit, labels, movingMask);
  if (segmentation.instanceIds.empty()) return labels;

  const cv::Rect image({}, labels.size());
  for (const core::Instance& instance : segmentation.instances) {
    const cv::Rect box = instance.box_px & image;
    if (!rules.isMovable(instance.classId) || box.empty()) continue;
    const cv::Mat mask = segmentation.instanceIds(box) == instance.id;
    cv::Mat part = labels(box);
    if (isMostlyDynamic(mask, box.tl(), test)) cv::bitwise_or(part, dynamicBit, part, mask);
  }
  return labels;
}

}  // namespace wardslam::filters
