// Budget: 2 ms each way for 640x480 with 1000 key points and n = 21.

#include <benchmark/benchmark.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>

#include <opencv2/imgproc.hpp>

#include "wardslam/mrpt_plugin/observation_semantic_rgbd.h"

namespace wardslam::mrpt_plugin {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr int kKeypoints = 1000;

/// Twelve things with uneven contours, key points of random numbers.
CObservationSemanticRGBD makeObservation() {
  CObservationSemanticRGBD o;
  o.camera.width_px = kWidth;
  o.camera.height_px = kHeight;
  cv::RNG random(1);
  o.segmentation.classIds = cv::Mat::zeros(kHeight, kWidth, CV_8UC1);
  o.segmentation.instanceIds = cv::Mat::zeros(kHeight, kWidth, CV_16UC1);
  for (int i = 1; i <= 12; ++i) {
    std::vector<cv::Point> contour;
    const cv::Point2d centre(random.uniform(0, kWidth), random.uniform(0, kHeight));
    for (int corner = 0; corner < 200; ++corner) {
      const double angle = corner * CV_2PI / 200;
      contour.emplace_back(centre + random.uniform(60.0, 70.0) * cv::Point2d(std::cos(angle), 1.5 * std::sin(angle)));
    }
    cv::fillPoly(o.segmentation.classIds, contour, i % 3 == 0 ? 1 : 56 + i);
    cv::fillPoly(o.segmentation.instanceIds, contour, i);
  }
  cv::threshold(o.segmentation.classIds, o.labelBits, 0, 10, cv::THRESH_BINARY);
  for (int i = 0; i < kKeypoints; ++i) {
    core::Keypoint k;
    k.raw_px = k.undistorted_px = {random.uniform(0.F, 639.F), random.uniform(0.F, 479.F)};
    k.depth_m = random.uniform(0.5F, 6.F);
    k.angle_rad = random.uniform(-3.F, 3.F);
    k.response = random.uniform(0.F, 1.F);
    o.features.keypoints.push_back(k);
  }
  o.states.assign(kKeypoints, KeypointState::Static);
  o.features.descriptors.create(kKeypoints, 32, CV_8UC1);
  random.fill(o.features.descriptors, cv::RNG::UNIFORM, 0, 256);
  return o;
}

void writeObservation(benchmark::State& state) {
  const auto observation = makeObservation();
  std::size_t size_bytes = 0;
  for (auto _ : state) {
    mrpt::io::CMemoryStream stream;
    mrpt::serialization::archiveFrom(stream) << observation;
    size_bytes = stream.getTotalBytesCount();
  }
  state.counters["bytes"] = static_cast<double>(size_bytes);
}
BENCHMARK(writeObservation)->Unit(benchmark::kMillisecond);

void readObservation(benchmark::State& state) {
  mrpt::rtti::registerClass(CLASS_ID(CObservationSemanticRGBD));
  mrpt::io::CMemoryStream stream;
  auto archive = mrpt::serialization::archiveFrom(stream);
  archive << makeObservation();
  for (auto _ : state) {
    stream.Seek(0);
    benchmark::DoNotOptimize(archive.ReadObject<CObservationSemanticRGBD>());
  }
}
BENCHMARK(readObservation)->Unit(benchmark::kMillisecond);

/// What reading leaves out, for those who want it.
void cutDescriptors(benchmark::State& state) {
  const auto observation = makeObservation();
  for (auto _ : state) benchmark::DoNotOptimize(observation.semanticDescriptors());
}
BENCHMARK(cutDescriptors)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace wardslam::mrpt_plugin
