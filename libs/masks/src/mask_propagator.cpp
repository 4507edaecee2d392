#include "mask_propagator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace wardslam::masks {
namespace {

constexpr std::size_t kMaxInstances = 254;
constexpr int kMinArea_px = 64;  ///< Of the bounding box; less is not worth carrying.
constexpr int kSampleStep_px = 2;

constexpr float kSpeed_mps = 1.5F;        ///< Of a person who walks, or the camera: depth changes by so much.
constexpr float kDepthNoise_m = 0.02F;    ///< And by noise, near,
constexpr float kDepthNoisePerM = 0.02F;  ///< and more so far away (the sensor measures disparity).
constexpr float kJoinDepth_m = 0.1F;      ///< Parts of one thing that lie side by side differ less.
constexpr float kBodyDepth_m = 0.5F;      ///< Half a person's reach: parts differ less from the middle of the whole.
constexpr float kMinSupport = 0.25F;      ///< Of the depth measured on an instance, this share must fit.

/// The instances by number: 1, 2, … in the order of the list; 0 is none of them.
using Number = std::uint8_t;
constexpr Number kOpen = 255;  ///< Not decided.

/// What depth says about an instance as a whole.
struct Body {
  std::vector<float> shifts_m;
  std::vector<float> depths_m;
  float shift_m = 0.0F;  ///< It came nearer (negative) or went away since the start of the trail.
  float depth_m = 0.0F;  ///< Where it is now; 0 = unknown.
  int measured_px = 0;
  int fitting_px = 0;

  [[nodiscard]] bool isSupported() const {
    return static_cast<float>(fitting_px) >= kMinSupport * static_cast<float>(measured_px);
  }
};
using Bodies = std::vector<Body>;

/// The start of the trail as seen from its end, and what is there now.
struct Scene {
  cv::Mat numbers;      ///< CV_8UC1, as expected.
  cv::Mat depthThen_m;  ///< CV_32FC1, as expected.
  cv::Mat depthNow_m;
  float elapsed_s = 0.0F;

  [[nodiscard]] float tolerance_m(float depth_m) const {
    return kDepthNoise_m + kDepthNoisePerM * depth_m + kSpeed_mps * elapsed_s;
  }
};

/// CV_8UC1 at `size`.
cv::Mat numberInstances(const core::Segmentation& masks, cv::Size size) {
  cv::Mat ids;
  cv::resize(masks.instanceIds, ids, size, 0, 0, cv::INTER_NEAREST);
  std::vector<Number> numberOf(1 << 16, 0);
  const std::size_t count = std::min(masks.instances.size(), kMaxInstances);
  for (std::size_t i = 0; i < count; ++i) numberOf[masks.instances[i].id] = static_cast<Number>(i + 1);
  cv::Mat numbers(size, CV_8UC1);
  std::transform(ids.begin<std::uint16_t>(), ids.end<std::uint16_t>(), numbers.begin<Number>(),
                 [&](std::uint16_t id) { return numberOf[id]; });
  return numbers;
}

Scene warp(const core::Segmentation& masks, const Trail& trail, const SmallPicture& now) {
  const cv::Mat numbers = numberInstances(masks, trail.places().size());
  cv::Mat places;
  cv::Mat unused;
  cv::convertMaps(trail.places(), cv::noArray(), places, unused, CV_16SC2, true);
  const auto look = [&](const cv::Mat& then) {
    cv::Mat seen;
    cv::remap(then, seen, places, cv::noArray(), cv::INTER_NEAREST, cv::BORDER_REPLICATE);
    return seen;
  };
  return {look(numbers), look(trail.start().depth_m), now.depth_m,
          static_cast<float>(now.stamp_s - trail.start().stamp_s)};
}

/// 0 of none. Changes the order.
float median(std::vector<float>& values) {
  if (values.empty()) return 0.0F;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Bodies measureBodies(const Scene& scene, std::size_t count) {
  Bodies bodies(count + 1);
  const float maxShift_m = 2 * kSpeed_mps * scene.elapsed_s + kJoinDepth_m;  // both may move
  for (int y = 0; y < scene.numbers.rows; y += kSampleStep_px) {
    const auto* number = scene.numbers.ptr<Number>(y);
    const auto* then_m = scene.depthThen_m.ptr<float>(y);
    const auto* now_m = scene.depthNow_m.ptr<float>(y);
    for (int x = 0; x < scene.numbers.cols; x += kSampleStep_px) {
      if (number[x] == 0 || then_m[x] <= 0 || now_m[x] <= 0) continue;
      if (std::abs(now_m[x] - then_m[x]) > maxShift_m) continue;
      bodies[number[x]].shifts_m.push_back(now_m[x] - then_m[x]);
      bodies[number[x]].depths_m.push_back(now_m[x]);
    }
  }
  for (Body& body : bodies) {
    body.shift_m = median(body.shifts_m);
    body.depth_m = median(body.depths_m);
  }
  return bodies;
}

/// What one pixel is, by itself. Counts support.
Number judge(const Scene& scene, Number expected, float then_m, float now_m, Bodies& bodies) {
  Body& body = bodies[expected];  // number 0: the background, which stays
  if (now_m <= 0) return expected;
  if (then_m <= 0) {
    const bool fits = expected != 0 && (body.depth_m <= 0 || std::abs(now_m - body.depth_m) < kBodyDepth_m);
    return fits ? expected : kOpen;
  }
  ++body.measured_px;
  if (std::abs(now_m - then_m - body.shift_m) > scene.tolerance_m(then_m)) return kOpen;
  ++body.fitting_px;
  return expected;
}

/// The number of each pixel now, or kOpen.
cv::Mat judgeAll(const Scene& scene, Bodies& bodies) {
  cv::Mat numbers(scene.numbers.size(), CV_8UC1);
  for (int y = 0; y < numbers.rows; ++y) {
    const auto* expected = scene.numbers.ptr<Number>(y);
    const auto* then_m = scene.depthThen_m.ptr<float>(y);
    const auto* now_m = scene.depthNow_m.ptr<float>(y);
    auto* number = numbers.ptr<Number>(y);
    for (int x = 0; x < numbers.cols; ++x) number[x] = judge(scene, expected[x], then_m[x], now_m[x], bodies);
  }
  return numbers;
}

/// Where most of what can be seen is another surface, the instance is gone.
void dropUnsupported(cv::Mat& numbers, const Bodies& bodies) {
  cv::Mat kept(1, 256, CV_8UC1);
  for (int number = 0; number < 256; ++number) {
    const auto i = static_cast<std::size_t>(number);
    const bool isDropped = i > 0 && i < bodies.size() && !bodies[i].isSupported();
    kept.at<Number>(number) = isDropped ? Number{0} : static_cast<Number>(number);
  }
  cv::LUT(numbers, kept, numbers);
}

/// Where to look for what a pixel belongs to: a close ring and a wide one.
struct Offset {
  int x;
  int y;
};
constexpr std::array<Offset, 24> kAround = {{{-2, -2}, {0, -2},  {2, -2}, {-2, 0}, {2, 0}, {-2, 2}, {0, 2},  {2, 2},
                                             {-5, -5}, {0, -5},  {5, -5}, {-5, 0}, {5, 0}, {-5, 5}, {0, 5},  {5, 5},
                                             {-8, -4}, {-4, -8}, {4, -8}, {8, -4}, {8, 4}, {4, 8},  {-4, 8}, {-8, 4}}};

/// The number that most of the surroundings at the depth of `at` have; kOpen when there are none.
Number vote(const cv::Mat& numbers, const cv::Mat& depth_m, cv::Point at) {
  std::array<Number, kAround.size()> voters{};
  std::size_t count = 0;
  const float own_m = depth_m.at<float>(at);
  for (const Offset& offset : kAround) {
    const cv::Point p(at.x + offset.x, at.y + offset.y);
    if (p.x < 0 || p.y < 0 || p.x >= numbers.cols || p.y >= numbers.rows) continue;
    const Number number = numbers.at<Number>(p);
    const float other_m = depth_m.at<float>(p);
    if (number != kOpen && other_m > 0 && std::abs(other_m - own_m) < kJoinDepth_m) voters[count++] = number;
  }
  Number best = kOpen;
  std::ptrdiff_t most = 1;  // a single one may be a stray
  for (std::size_t i = 0; i < count; ++i) {
    const auto votes = std::count(voters.begin() + static_cast<std::ptrdiff_t>(i),
                                  voters.begin() + static_cast<std::ptrdiff_t>(count), voters[i]);
    if (votes > most) {
      most = votes;
      best = voters[i];
    }
  }
  return best;
}

/// Pixels that are something else than expected join what lies beside them, in space too. Going through the image
/// forth and back, whole regions join that were not in view before.
void joinOpen(cv::Mat& numbers, const cv::Mat& depth_m) {
  std::vector<cv::Point> open;
  cv::findNonZero(numbers == kOpen, open);
  const auto join = [&](const cv::Point& at) {
    Number& number = numbers.at<Number>(at);
    if (number == kOpen) number = vote(numbers, depth_m, at);
  };
  std::for_each(open.begin(), open.end(), join);
  std::for_each(open.rbegin(), open.rend(), join);
}

/// The bounding box of each number.
std::array<cv::Rect, 256> boxesOf(const cv::Mat& numbers) {
  std::array<cv::Rect, 256> boxes;
  for (int y = 0; y < numbers.rows; ++y) {
    const auto* row = numbers.ptr<Number>(y);
    for (int begin = 0, end = 0; begin < numbers.cols; begin = end) {
      for (end = begin; end < numbers.cols && row[end] == row[begin];) ++end;
      boxes[row[begin]] |= cv::Rect(begin, y, end - begin, 1);
    }
  }
  return boxes;
}

/// The masks at full size, without the instances of which nothing is left.
core::Segmentation paint(const cv::Mat& smallNumbers, const std::vector<core::Instance>& instances, cv::Size size) {
  core::Segmentation result;
  cv::Mat numbers;
  cv::resize(smallNumbers, numbers, size, 0, 0, cv::INTER_NEAREST);
  const auto boxes = boxesOf(numbers);
  cv::Mat ids(1, 256, CV_16UC1, cv::Scalar(0));
  cv::Mat classes(1, 256, CV_8UC1, cv::Scalar(0));
  for (std::size_t i = 0; i < std::min(instances.size(), kMaxInstances); ++i) {
    const auto number = static_cast<int>(i + 1);
    if (boxes[i + 1].area() < kMinArea_px) continue;
    core::Instance instance = instances[i];
    instance.box_px = boxes[i + 1];
    ids.at<std::uint16_t>(number) = instance.id;
    classes.at<core::ClassId>(number) = instance.classId;
    result.instances.push_back(instance);
  }
  cv::LUT(numbers, ids, result.instanceIds);
  cv::LUT(numbers, classes, result.classIds);
  return result;
}

}  // namespace

core::Segmentation carryMasks(const core::Segmentation& masks, const Trail& trail, const SmallPicture& now) {
  if (masks.empty()) return {};
  const Scene scene = warp(masks, trail, now);
  Bodies bodies = measureBodies(scene, std::min(masks.instances.size(), kMaxInstances));
  cv::Mat numbers = judgeAll(scene, bodies);
  dropUnsupported(numbers, bodies);
  joinOpen(numbers, scene.depthNow_m);
  return paint(numbers, masks.instances, masks.classIds.size());
}

}  // namespace wardslam::masks
