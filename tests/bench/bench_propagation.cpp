// Budget: all that carrying masks adds to a frame at most 6 ms on one core.

#include <benchmark/benchmark.h>

#include <opencv2/imgproc.hpp>
#include <vector>

#include "mask_propagator.h"
#include "wardslam/masks/image_motion.h"
#include "wardslam/masks/instance_tracker.h"

namespace wardslam::segmentation {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 480;

/// A textured wall 4 m away, with people and things of random texture at 1.5 to 3 m before it. Everything shifts
/// between the two moments: the wall by 6 px, as when the camera turns, the things by as much again.
struct Scene {
  cv::Mat gray;
  cv::Mat depth_m;
  core::Segmentation masks;
};

cv::Mat texture(std::uint64_t seed) {
  cv::RNG random(seed);
  cv::Mat image(kHeight, kWidth, CV_8UC1);
  random.fill(image, cv::RNG::UNIFORM, 0, 256);
  cv::GaussianBlur(image, image, {}, 2.5);
  cv::normalize(image, image, 20, 235, cv::NORM_MINMAX);
  return image;
}

cv::Mat shifted(const cv::Mat& image, int x_px) {
  cv::Mat result;
  cv::warpAffine(image, result, cv::Matx23d(1, 0, x_px, 0, 1, 0), image.size(), cv::INTER_NEAREST, cv::BORDER_WRAP);
  return result;
}

Scene sceneAt(int moment, int instances) {
  Scene scene{shifted(texture(1), 6 * moment),
              cv::Mat(kHeight, kWidth, CV_32FC1, cv::Scalar(4.0)),
              {cv::Mat::zeros(kHeight, kWidth, CV_8UC1), cv::Mat::zeros(kHeight, kWidth, CV_16UC1), {}}};
  for (int i = 0; i < instances; ++i) {
    const cv::Point centre((i * 140 + 90) % kWidth + 12 * moment, 160 + 80 * (i % 3));
    cv::Mat shape(kHeight, kWidth, CV_8UC1, cv::Scalar(0));
    cv::ellipse(shape, centre, {35 + 3 * i, 90}, 0, 0, 360, 255, cv::FILLED);
    shifted(texture(static_cast<std::uint64_t>(i) + 2), 12 * moment).copyTo(scene.gray, shape);
    scene.depth_m.setTo(1.5 + 0.15 * i, shape);
    scene.masks.classIds.setTo(i % 2 == 0 ? 1 : 57, shape);
    scene.masks.instanceIds.setTo(i + 1, shape);
    const auto classId = static_cast<core::ClassId>(i % 2 == 0 ? 1 : 57);
    scene.masks.instances.push_back({static_cast<std::uint16_t>(i + 1), classId, 0.9F, cv::boundingRect(shape)});
  }
  return scene;
}

/// Per frame: reduce the picture, measure its motion, lengthen the trails of the newest and of the pending masks,
/// carry the masks.
void propagateFrame(benchmark::State& state) {
  cv::setNumThreads(1);
  const int instances = static_cast<int>(state.range(0));
  const std::vector<Scene> scenes = {sceneAt(0, instances), sceneAt(1, instances)};
  masks::ImageMotion motion;
  motion.advance(masks::shrink(scenes[0].gray, scenes[0].depth_m, 0.0));
  const masks::Trail start(motion.picture());
  std::size_t i = 0;
  for (auto _ : state) {
    i = 1 - i;
    motion.advance(masks::shrink(scenes[i].gray, scenes[i].depth_m, 0.033));
    masks::Trail newest = start;
    masks::Trail pending = start;
    newest.follow(motion.step());
    pending.follow(motion.step());
    benchmark::DoNotOptimize(masks::carryMasks(scenes[1 - i].masks, newest, motion.picture()));
    cv::Mat places = pending.places();
    benchmark::DoNotOptimize(places);
  }
}
BENCHMARK(propagateFrame)->Arg(1)->Arg(3)->Arg(12)->Unit(benchmark::kMillisecond);

void trackInstances(benchmark::State& state) {
  const Scene before = sceneAt(0, 12);
  const Scene now = sceneAt(1, 12);
  for (auto _ : state) {
    masks::InstanceTracker tracker({});
    const core::Segmentation carried = tracker.update(before.masks, {}, 0.0);
    benchmark::DoNotOptimize(tracker.update(now.masks, carried, 0.033));
  }
}
BENCHMARK(trackInstances)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace wardslam::segmentation
