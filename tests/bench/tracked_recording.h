#pragma once

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>

#include "wardslam/exchange/tum_trajectory.h"
#include "wardslam/pipeline/slam_system.h"

/// What programs share that track a recording and compare with the truth.
namespace wardslam::bench {

constexpr double kSameImage_s = 0.02;

class Truth {
 public:
  explicit Truth(const std::string& file) : trajectory_(exchange::readTumTrajectory(file)) {}

  [[nodiscard]] const Eigen::Isometry3d* at(double stamp_s) const {
    const auto isBefore = [](const core::StampedPose& pose, double t) { return pose.stamp_s < t; };
    const auto next = std::lower_bound(trajectory_.begin(), trajectory_.end(), stamp_s - kSameImage_s, isBefore);
    const bool isThere = next != trajectory_.end() && next->stamp_s < stamp_s + kSameImage_s;
    return isThere ? &next->T_map_cam : nullptr;
  }

 private:
  core::Trajectory trajectory_;
};

/// Graph and tracking, nothing else, and the same every time. `config`: a file; empty: none.
inline pipeline::SlamOptions trackingAlone(const std::string& config) {
  pipeline::SlamOptions options = config.empty() ? pipeline::SlamOptions{} : pipeline::readSlamOptions(config);
  options.deterministic = true;
  options.mapping.enabled = false;
  options.annotate = false;
  options.filters = pipeline::SlamOptions::noFilters();
  return options;
}

/// `run(recording, truth, config)` with what stands on the command line; the exit code.
template <class Run>
int measure(const char* program, int count, char** arguments, Run&& run) {
  if (count < 3) {
    std::fprintf(stderr, "%s RECORDING GROUNDTRUTH [CONFIG]\n", program);
    return 2;
  }
  try {
    run(arguments[1], arguments[2], count > 3 ? arguments[3] : "");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", program, error.what());
    return 1;
  }
  return 0;
}

}  // namespace wardslam::bench
