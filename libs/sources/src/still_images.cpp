#include "still_images.h"

#include <algorithm>
#include <cstring>

namespace wardslam::sources {
namespace {

/// Ends at the first row that differs, which nearly always is the first.
bool areEqual(const cv::Mat& a, const cv::Mat& b) {
  if (a.empty() || a.size() != b.size() || a.type() != b.type()) return false;
  const std::size_t row_bytes = static_cast<std::size_t>(a.cols) * a.elemSize();
  for (int y = 0; y < a.rows; ++y) {
    if (std::memcmp(a.ptr(y), b.ptr(y), row_bytes) != 0) return false;
  }
  return true;
}

}  // namespace

void StillImages::look(core::Frame& frame) {
  const bool isColorRepeated = areEqual(frame.gray, gray_);
  const bool isDepthRepeated = areEqual(frame.depth_m, depth_m_);
  gray_ = frame.gray;
  depth_m_ = frame.depth_m;
  if (isDepthRepeated) {
    ++repeats_;
  } else {
    if (frame.stamp_s - depthSince_s_ <= kLowestRate_s) usual_ = std::max(usual_, repeats_);
    repeats_ = 0;
    depthSince_s_ = frame.stamp_s;
  }
  if (isColorRepeated) {
    ++frame.events["sources.image_repeated"];
    return;
  }
  if (repeats_ <= usual_ || cv::countNonZero(frame.depth_m) == 0) return;
  ++frame.events["sources.depth_still"];
  frame.depth_m = cv::Mat(frame.depth_m.size(), frame.depth_m.type(), cv::Scalar(0));
}

}  // namespace wardslam::sources
