// Budget: all that carrying masks adds to a frame at most 6 ms on one core.

#include <benchmark/benchmark.h>

#include <vector>

#include "mask_propagator.h"
#include "moving_scene.h"
#include "wardslam/masks/image_motion.h"
#include "wardslam/masks/instance_tracker.h"

namespace wardslam::segmentation {
namespace {

using bench::Scene;
using bench::sceneAt;

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
