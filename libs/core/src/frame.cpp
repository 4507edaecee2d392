#include "wardslam/core/frame.h"

namespace wardslam::core {
namespace {

void addTo(cv::Mat& bits, const cv::Mat& more) {
  CV_Assert(more.type() == CV_8UC1);
  bits = bits.empty() ? more.clone() : cv::Mat(bits | more);
}

}  // namespace

void addMayMove(Frame& frame, const cv::Mat& mask) { addTo(frame.mayMove, mask); }

void addLabels(Frame& frame, const cv::Mat& labelBits) { addTo(frame.labelBits, labelBits); }

void addDynamic(Frame& frame, const cv::Mat& mask) {
  addMayMove(frame, mask);
  addLabels(frame, (mask != 0) & bitOf(PixelLabel::Dynamic));
}

cv::Mat dynamicPixels(const Frame& frame) {
  if (frame.labelBits.empty()) return {};
  return (frame.labelBits & bitOf(PixelLabel::Dynamic)) != 0;
}

}  // namespace wardslam::core
