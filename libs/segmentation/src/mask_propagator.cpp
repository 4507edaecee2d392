#include "wardslam/segmentation/mask_propagator.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace wardslam::segmentation {
namespace {

// Of the small picture, 320 pixels wide.
constexpr int kReach_px = 8;     ///< How far from its confirmed pixels an instance may take in more.
constexpr int kMinArea_px = 16;  ///< Less than this is not worth carrying.
constexpr int kSampleStep_px = 2;

constexpr float kSpeed_mps = 1.5F;        ///< Of a person who walks, or the camera: depth changes by so much.
constexpr float kDepthNoise_m = 0.02F;    ///< And by noise, near,
constexpr float kDepthNoisePerM = 0.02F;  ///< and more so far away (quantisation of the disparity).
constexpr float kJoinDepth_m = 0.15F;     ///< A part of the instance differs less from the parts around it.
constexpr float kBodyDepth_m = 0.5F;      ///< … and from the whole of it: half a person's reach.
constexpr float kMinSupport = 0.25F;      ///< Of the depth measured on an instance, this share must fit.

/// The start of the trail as seen from its end.
struct Expectation {
  cv::Mat ids;      ///< CV_16UC1
  cv::Mat depth_m;  ///< CV_32FC1
};

/// One instance, within its part of the image.
struct Candidate {
  cv::Mat expected;     ///< CV_8UC1 mask, as warped.
  cv::Mat others;       ///< Where another instance is expected.
  cv::Mat depthThen_m;  ///< Expected depth.
  cv::Mat depthNow_m;
};

Expectation warp(const core::Segmentation& masks, const Trail& trail) {
  cv::Mat small;
  cv::resize(masks.instanceIds, small, trail.places().size(), 0, 0, cv::INTER_NEAREST);
  cv::Mat fixedPlaces;
  cv::Mat unused;
  cv::convertMaps(trail.places(), cv::noArray(), fixedPlaces, unused, CV_16SC2, true);
  Expectation expectation;
  cv::remap(small, expectation.ids, fixedPlaces, cv::noArray(), cv::INTER_NEAREST, cv::BORDER_REPLICATE);
  cv::remap(trail.start().depth_m, expectation.depth_m, fixedPlaces, cv::noArray(), cv::INTER_NEAREST,
            cv::BORDER_REPLICATE);
  return expectation;
}

/// The part of the image that each instance is in.
std::map<std::uint16_t, cv::Rect> findBoxes(const cv::Mat& ids) {
  std::map<std::uint16_t, cv::Rect> boxes;
  for (int y = 0; y < ids.rows; ++y) {
    const auto* row = ids.ptr<std::uint16_t>(y);
    for (int begin = 0, end = 0; begin < ids.cols; begin = end) {
      for (end = begin; end < ids.cols && row[end] == row[begin];) ++end;
      if (row[begin] != 0) boxes[row[begin]] |= cv::Rect(begin, y, end - begin, 1);
    }
  }
  return boxes;
}

/// Of values that need not be sorted; 0 of none.
float median(std::vector<float>& values) {
  if (values.empty()) return 0.0F;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// What depth says about an instance as a whole.
struct Body {
  float shift_m = 0.0F;  ///< It came nearer (negative) or went away since the start of the trail.
  float depth_m = 0.0F;  ///< Where it is now; 0 = unknown.
};

Body measureBody(const Candidate& candidate, float maxShift_m) {
  std::vector<float> shifts_m;
  std::vector<float> depths_m;
  for (int y = 0; y < candidate.expected.rows; y += kSampleStep_px) {
    const auto* expected = candidate.expected.ptr<std::uint8_t>(y);
    const auto* then_m = candidate.depthThen_m.ptr<float>(y);
    const auto* now_m = candidate.depthNow_m.ptr<float>(y);
    for (int x = 0; x < candidate.expected.cols; x += kSampleStep_px) {
      if (expected[x] == 0 || then_m[x] <= 0 || now_m[x] <= 0) continue;
      const float shift_m = now_m[x] - then_m[x];
      if (std::abs(shift_m) > maxShift_m) continue;
      shifts_m.push_back(shift_m);
      depths_m.push_back(now_m[x]);
    }
  }
  return {median(shifts_m), median(depths_m)};
}

/// Mean depth of the confirmed pixels around each pixel; 0 where there are too few.
cv::Mat depthAround(const cv::Mat& confirmed, const cv::Mat& depth_m) {
  const cv::Size side(2 * kReach_px + 1, 2 * kReach_px + 1);
  cv::Mat count;
  cv::Mat sum_m = cv::Mat::zeros(depth_m.size(), CV_32FC1);
  depth_m.copyTo(sum_m, confirmed);
  confirmed.convertTo(count, CV_32F, 1.0 / 255.0);
  cv::boxFilter(count, count, CV_32F, side, {-1, -1}, false);
  cv::boxFilter(sum_m, sum_m, CV_32F, side, {-1, -1}, false);
  cv::Mat mean_m = sum_m / cv::max(count, 1.0);
  mean_m.setTo(0, count < 1.5);
  return mean_m;
}

/// The mask of one instance now (CV_8UC1), empty when it finds no support.
cv::Mat settle(const Candidate& candidate, float elapsed_s) {
  const cv::Mat& expected = candidate.expected;
  const cv::Mat& now_m = candidate.depthNow_m;
  const cv::Mat& then_m = candidate.depthThen_m;
  const cv::Mat hasNow = now_m > 0;
  const cv::Mat hasBoth = hasNow & (then_m > 0);
  const float maxShift_m = kSpeed_mps * elapsed_s;
  const Body body = measureBody(candidate, 2 * maxShift_m + kJoinDepth_m);

  const cv::Mat tolerance_m = then_m * kDepthNoisePerM + (kDepthNoise_m + maxShift_m);
  const cv::Mat change_m = now_m - then_m;
  const cv::Mat confirmed = (cv::abs(change_m - body.shift_m) < tolerance_m) & hasBoth & expected;
  const int measured = cv::countNonZero(hasBoth & expected);
  const int supporting = cv::countNonZero(confirmed);
  if (static_cast<float>(supporting) < kMinSupport * static_cast<float>(measured)) return {};

  const cv::Mat background = (cv::abs(change_m) < tolerance_m) & hasBoth & ~expected;
  const cv::Mat joined =
      (cv::abs(now_m - depthAround(confirmed, now_m)) < kJoinDepth_m) & hasNow & ~background & ~candidate.others;
  cv::Mat unmeasured = expected & ~hasBoth;
  if (body.depth_m > 0) unmeasured &= ~hasNow | (cv::abs(now_m - body.depth_m) < kBodyDepth_m);

  cv::Mat mask = confirmed | joined | unmeasured;
  cv::medianBlur(mask, mask, 5);  // closes what the depth sensor missed, drops crumbs
  return cv::countNonZero(mask) < kMinArea_px ? cv::Mat() : mask;
}

Candidate cut(const Expectation& expectation, const cv::Mat& depthNow_m, std::uint16_t id, const cv::Rect& part) {
  const cv::Mat ids = expectation.ids(part);
  const cv::Mat expected = ids == id;
  return {expected, (ids != 0) & ~expected, expectation.depth_m(part), depthNow_m(part)};
}

/// Puts the mask of an instance, found at `part` of the small picture, into the result.
void paint(const cv::Mat& smallMask, const cv::Rect& part, cv::Size small, core::Instance instance,
           core::Segmentation& result) {
  const cv::Size full = result.classIds.size();
  const auto scaled = [](int at, int from, int to) { return at * to / from; };
  const cv::Point first(scaled(part.x, small.width, full.width), scaled(part.y, small.height, full.height));
  const cv::Point last(scaled(part.br().x, small.width, full.width), scaled(part.br().y, small.height, full.height));
  const cv::Rect area(first, last);
  cv::Mat mask;
  cv::resize(smallMask, mask, area.size(), 0, 0, cv::INTER_NEAREST);
  result.classIds(area).setTo(instance.classId, mask);
  result.instanceIds(area).setTo(instance.id, mask);
  instance.box_px = cv::boundingRect(mask) + area.tl();
  result.instances.push_back(instance);
}

cv::Rect widen(const cv::Rect& box, cv::Size image) {
  const cv::Point reach(kReach_px, kReach_px);
  return cv::Rect(box.tl() - reach, box.br() + reach) & cv::Rect({}, image);
}

}  // namespace

core::Segmentation carryMasks(const core::Segmentation& masks, const Trail& trail, const SmallPicture& now) {
  core::Segmentation result;
  if (masks.empty()) return result;
  result.classIds = cv::Mat(masks.classIds.size(), CV_8UC1, cv::Scalar(0));
  result.instanceIds = cv::Mat(masks.classIds.size(), CV_16UC1, cv::Scalar(0));
  if (masks.instances.empty()) return result;

  const Expectation expectation = warp(masks, trail);
  const auto boxes = findBoxes(expectation.ids);
  const auto elapsed_s = static_cast<float>(now.stamp_s - trail.start().stamp_s);
  for (const core::Instance& instance : masks.instances) {
    const auto box = boxes.find(instance.id);
    if (box == boxes.end()) continue;
    const cv::Rect part = widen(box->second, expectation.ids.size());
    const cv::Mat mask = settle(cut(expectation, now.depth_m, instance.id, part), elapsed_s);
    if (!mask.empty()) paint(mask, part, expectation.ids.size(), instance, result);
  }
  return result;
}

}  // namespace wardslam::segmentation
