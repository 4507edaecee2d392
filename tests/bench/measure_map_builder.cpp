// usage: measure_map_builder RECORDING [FILTERED]
//
// Time per frame of a CMetricMapBuilderSemantic and of the SlamSystem it drives, frame by frame in turn, so that both
// have the same machine; and whether their poses, clouds and things are the same. Filters are left out unless a second
// argument is given.

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/poses/CPose3DPDFGaussian.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <iostream>
#include <vector>

#include "wardslam/core/mrpt_compat.h"
#include "wardslam/mapping/cloud_in_map.h"
#include "wardslam/mrpt_slam/semantic_map_builder.h"
#include "wardslam/pipeline/slam_system.h"
#include "wardslam/sources/observation_source.h"

namespace {

using namespace wardslam;

template <class Do>
double milliseconds(const Do& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

double medianOf(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

double sumOf(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum;
}

std::vector<Eigen::Vector3f> pointsOf(const mapping::SemanticMap& map) {
  std::vector<Eigen::Vector3f> points_m;
  mapping::forEachCloudPoint(
      map, [&](const Eigen::Vector3f& p_m, const mapping::SemanticPoint&) { points_m.push_back(p_m); });
  return points_m;
}

/// Things of `a` that `b` has by the same number: of the same class and state, in the same place.
std::size_t sameThings(const mapping::SemanticMap& a, const mapping::SemanticMap& b) {
  std::size_t same = 0;
  for (const auto& [id, thing] : a.objects) {
    const auto other = b.objects.find(id);
    same += other != b.objects.end() && other->second.classId == thing.classId && other->second.state == thing.state &&
                    other->second.centroid_m == thing.centroid_m
                ? 1
                : 0;
  }
  return same;
}

void measure(const std::string& recording, bool isFiltered) {
  pipeline::SlamOptions options;
  options.deterministic = true;
  if (!isFiltered) options.filters = pipeline::SlamOptions::noFilters();
  pipeline::SlamSystem slam(options, {}, pipeline::WhenBehind::Waits);
  mrpt_slam::CMetricMapBuilderSemantic builder;
  builder.configuration.slam = options;
  builder.initialize();

  const auto first = sources::openSource(recording, {});
  const auto second = sources::openSource(recording, {});
  std::vector<double> ofSystem_ms;
  std::vector<double> ofBuilder_ms;
  double farthest_m = 0.0;
  while (const auto observation = first->next()) {
    const auto same = second->next();
    const auto feedSystem = [&] { ofSystem_ms.push_back(milliseconds([&] { slam.process(observation); })); };
    const auto feedBuilder = [&] {
      ofBuilder_ms.push_back(milliseconds([&] {
        builder.processObservation(same);
        static_cast<void>(builder.getCurrentPoseEstimation());
      }));
    };
    if (ofSystem_ms.size() % 2 == 0) feedSystem();
    feedBuilder();
    if (ofSystem_ms.size() < ofBuilder_ms.size()) feedSystem();
  }
  if (ofSystem_ms.empty()) throw std::runtime_error(recording + ": holds no frames");
  slam.finish();
  builder.finish();
  const auto expected = slam.trajectory();
  const auto trajectory = builder.trajectory();
  for (std::size_t i = 0; i < std::min(expected.size(), trajectory.size()); ++i) {
    const Eigen::Isometry3d difference = expected[i].T_map_cam.inverse() * trajectory[i].T_map_cam;
    farthest_m = std::max(farthest_m, difference.translation().norm());
  }
  const mapping::SemanticMap ofSystem = slam.semanticMap();
  const mapping::SemanticMap ofBuilder = builder.semanticMap();
  std::cout << "frames: " << ofSystem_ms.size() << ", in the map: " << expected.size() << " and " << trajectory.size()
            << ", poses differ by at most " << farthest_m << " m\n"
            << "points of the two clouds: " << pointsOf(ofSystem).size() << " and " << pointsOf(ofBuilder).size()
            << ", the same to the last bit: " << (pointsOf(ofSystem) == pointsOf(ofBuilder) ? "yes" : "no")
            << "; things: " << sameThings(ofSystem, ofBuilder) << " of " << ofSystem.objects.size() << " and "
            << ofBuilder.objects.size() << " the same\n"
            << "SlamSystem: median " << medianOf(ofSystem_ms) << " ms, sum " << sumOf(ofSystem_ms) << " ms\n"
            << "map builder: median " << medianOf(ofBuilder_ms) << " ms, sum " << sumOf(ofBuilder_ms) << " ms\n"
            << "ratio: median " << medianOf(ofBuilder_ms) / medianOf(ofSystem_ms) << ", sum "
            << sumOf(ofBuilder_ms) / sumOf(ofSystem_ms) << "\n";
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 2) throw std::runtime_error("usage: measure_map_builder RECORDING [FILTERED]");
  measure(argv[1], argc > 2);
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
