// The paper's rule by the letter (bench_filter_chain times what ships). Budgets: descriptors and dynamic test together
// at most 0.5 ms per frame at n = 21, and nearly flat in n.

#include <benchmark/benchmark.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <opencv2/imgproc.hpp>

#include "dynamic_test.h"
#include "wardslam/core/data_files.h"
#include "wardslam/features/semantic_descriptor.h"
#include "wardslam/filters/annotation.h"
#include "wardslam/knowledge/knowledge_graph.h"

namespace wardslam {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr int kKeypoints = 1000;

knowledge::KnowledgeGraph hospital() {
  return knowledge::KnowledgeGraph::fromFile(core::findDataFile("knowledge/hospital.yaml"));
}

/// Two people, four chairs, a cup and a bed: the round shapes fill about half of the image.
core::Segmentation wardScene() {
  core::Segmentation scene;
  scene.classIds = cv::Mat(kHeight, kWidth, CV_8UC1, cv::Scalar(0));
  scene.instanceIds = cv::Mat(kHeight, kWidth, CV_16UC1, cv::Scalar(0));
  const auto put = [&](core::ClassId c, cv::Point centre, cv::Size radii) {
    const auto id = static_cast<std::uint16_t>(scene.instances.size() + 1);
    cv::ellipse(scene.classIds, centre, radii, 0, 0, 360, cv::Scalar(c), cv::FILLED);
    cv::ellipse(scene.instanceIds, centre, radii, 0, 0, 360, cv::Scalar(id), cv::FILLED);
    const cv::Rect box(centre.x - radii.width, centre.y - radii.height, 2 * radii.width + 1, 2 * radii.height + 1);
    scene.instances.push_back({id, c, 0.9F, box & cv::Rect(0, 0, kWidth, kHeight)});
  };
  put(60, {320, 420}, {200, 70});
  for (const int x : {80, 230, 400, 560}) put(57, {x, 300}, {60, 90});
  put(1, {170, 200}, {50, 160});
  put(1, {480, 220}, {60, 180});
  put(42, {230, 180}, {12, 16});
  return scene;
}

std::vector<core::Keypoint> randomKeypoints() {
  cv::RNG random(1);
  std::vector<core::Keypoint> keypoints(kKeypoints);
  for (auto& keypoint : keypoints) {
    keypoint.raw_px = {random.uniform(0.0F, float{kWidth - 1}), random.uniform(0.0F, float{kHeight - 1})};
    keypoint.angle_rad = random.uniform(-3.14F, 3.14F);
  }
  return keypoints;
}

void dynamicTest(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  filters::DynamicTest test({hospital(), core::LabelSpace::coco()}, {n, n * n / 8});
  const cv::Mat classIds = wardScene().classIds;
  std::vector<core::Keypoint> keypoints = randomKeypoints();
  for (auto _ : state) {
    test.setImage(classIds);
    test.mark(keypoints);
    benchmark::DoNotOptimize(keypoints.data());
  }
}
BENCHMARK(dynamicTest)->Arg(5)->Arg(21)->Arg(55)->Unit(benchmark::kMicrosecond);

void describeAll(benchmark::State& state) {
  const cv::Mat classIds = wardScene().classIds;
  const std::vector<core::Keypoint> keypoints = randomKeypoints();
  for (auto _ : state) {
    benchmark::DoNotOptimize(features::describeSemantics(classIds, keypoints, static_cast<int>(state.range(0))));
  }
}
BENCHMARK(describeAll)->Arg(5)->Arg(21)->Arg(55)->Unit(benchmark::kMicrosecond);

/// What the filter adds to a frame whose masks are there: descriptors, which are read out when they are compared, and
/// the test.
void descriptorsAndTest(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  filters::DynamicTest test({hospital(), core::LabelSpace::coco()}, {n, n * n / 8});
  const cv::Mat classIds = wardScene().classIds;
  core::Features found;
  found.keypoints = randomKeypoints();
  for (auto _ : state) {
    found.semanticDescriptors = std::make_shared<features::SemanticDescriptors>(classIds, n);
    test.setImage(classIds);
    test.mark(found.keypoints);
    benchmark::DoNotOptimize(found);
  }
}
BENCHMARK(descriptorsAndTest)->Arg(5)->Arg(21)->Arg(55)->Unit(benchmark::kMicrosecond);

void distanceOfAll(benchmark::State& state) {
  const cv::Mat classIds = wardScene().classIds;
  const auto keypoints = randomKeypoints();
  const features::SemanticDescriptors ofImage(classIds, 21);
  std::vector<core::SemanticDescriptor> descriptors;
  for (const core::Keypoint& keypoint : keypoints) descriptors.push_back(ofImage.of(keypoint));
  for (auto _ : state) {
    for (std::size_t i = 1; i < descriptors.size(); ++i) {
      benchmark::DoNotOptimize(core::differenceOf(descriptors[i - 1], descriptors[i]));
    }
  }
}
BENCHMARK(distanceOfAll)->Unit(benchmark::kMicrosecond);

void annotateObservation(benchmark::State& state) {
  core::Frame frame;
  frame.observation = std::make_shared<mrpt::obs::CObservation3DRangeScan>();
  frame.observation->rangeImage_setSize(kHeight, kWidth);
  core::addDynamic(frame, wardScene().classIds == 1);
  for (auto _ : state) {
    filters::annotateObservation(frame);
  }
}
BENCHMARK(annotateObservation)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace wardslam
