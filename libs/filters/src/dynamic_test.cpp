#include "dynamic_test.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace wardslam::filters {
namespace {

cv::Mat tableOf(const knowledge::ClassSet& classes) {
  cv::Mat table(1, 256, CV_8UC1);
  for (int c = 0; c < 256; ++c) table.at<std::uint8_t>(c) = classes[static_cast<std::size_t>(c)] ? 1 : 0;
  return table;
}

}  // namespace

DynamicTest::DynamicTest(const knowledge::MotionRules& rules, const DynamicTestOptions& options)
    : options_(options), moving_(rules.moving()) {
  CV_Assert(options.n % 2 == 1);
  moversOf_.fill(kNobody);
  for (std::size_t c = 0; c < moversOf_.size(); ++c) {
    const auto id = static_cast<core::ClassId>(c);
    const knowledge::ClassSet& classes = rules.movers(id);
    if (!rules.isMovable(id) || classes.none()) continue;
    auto same = std::find_if(movers_.begin(), movers_.end(), [&](const Movers& m) { return m.classes == classes; });
    if (same == movers_.end()) same = movers_.insert(same, {classes, tableOf(classes), {}});
    moversOf_[c] = static_cast<int>(same - movers_.begin());
  }
}

void DynamicTest::setImage(const cv::Mat& classIds) {
  CV_Assert(classIds.type() == CV_8UC1 && !classIds.empty());
  classIds_ = classIds;
  for (Movers& movers : movers_) movers.integral.release();
}

core::Motion DynamicTest::at(cv::Point raw_px) {
  const cv::Point pixel(std::clamp(raw_px.x, 0, classIds_.cols - 1), std::clamp(raw_px.y, 0, classIds_.rows - 1));
  const auto c = classIds_.at<core::ClassId>(pixel);
  if (moving_[c]) return core::Motion::Dynamic;
  const int movers = moversOf_[c];
  if (movers == kNobody) return core::Motion::Static;
  const int count = countMovers(movers_[static_cast<std::size_t>(movers)], pixel);
  return count > options_.delta ? core::Motion::Dynamic : core::Motion::Static;
}

cv::Mat DynamicTest::mask(const cv::Mat& decided) {
  cv::Mat mask(classIds_.size(), CV_8UC1, cv::Scalar(0));
  for (int y = 0; y < mask.rows; ++y) {
    const auto* classes = classIds_.ptr<core::ClassId>(y);
    const auto* isDecided = decided.empty() ? nullptr : decided.ptr<std::uint8_t>(y);
    auto* row = mask.ptr<std::uint8_t>(y);
    for (int x = 0; x < mask.cols; ++x) {
      const core::ClassId c = classes[x];
      const bool mayBe = moving_[c] || moversOf_[c] != kNobody;
      const bool isAsked = isDecided == nullptr || isDecided[x] == 0;
      if (mayBe && isAsked && at({x, y}) == core::Motion::Dynamic) row[x] = 255;
    }
  }
  return mask;
}

void DynamicTest::mark(std::vector<core::Keypoint>& keypoints) {
  for (core::Keypoint& keypoint : keypoints) {
    if (at(keypoint.raw_px) == core::Motion::Dynamic) keypoint.motion = core::Motion::Dynamic;
  }
}

int DynamicTest::countMovers(Movers& movers, cv::Point raw_px) const {
  if (movers.integral.empty()) {
    cv::Mat isMover;
    cv::LUT(classIds_, movers.isMover, isMover);
    cv::integral(isMover, movers.integral, CV_32S);
  }
  const int radius = options_.n / 2;
  const int left = std::max(raw_px.x - radius, 0);
  const int top = std::max(raw_px.y - radius, 0);
  const int right = std::min(raw_px.x + radius + 1, classIds_.cols);
  const int bottom = std::min(raw_px.y + radius + 1, classIds_.rows);
  const cv::Mat& sum = movers.integral;
  return sum.at<int>(bottom, right) - sum.at<int>(top, right) - sum.at<int>(bottom, left) + sum.at<int>(top, left);
}

}  // namespace wardslam::filters
