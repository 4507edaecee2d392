#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "graph/synthetic_walk.h"
#include "wardslam/graph/mapper.h"

namespace wardslam::graph {

inline constexpr int kRound = test::SyntheticWalk::kKeyframesPerRound;

inline GraphOptions fewAndFast() {
  GraphOptions options;
  options.bundle_adjustment.window = 4;
  options.bundle_adjustment.local_iterations = 4;
  options.place_recognition.min_keyframe_gap = 10;
  return options;
}

/// A round and a bit; half way, tracking loses all points and slips by `slip`.
class MapperWalk : public ::testing::Test {
 protected:
  static constexpr int kKeyframes = kRound + 5;

  void walk(Mapper& mapper, const Eigen::Isometry3d& slip) {
    for (int i = 0; i < kKeyframes; ++i) {
      const bool slips = i == kRound / 2;
      if (slips) walk_.forgetPoints();
      insert(mapper, walk_.step(slips ? slip : Eigen::Isometry3d::Identity()));
    }
  }

  void insert(Mapper& mapper, const std::shared_ptr<const odometry::Keyframe>& keyframe) {
    const std::size_t loops = mapper.loops().size();
    const auto update = mapper.insert(keyframe);
    if (mapper.loops().size() > loops) closings_.push_back(update);
  }

  [[nodiscard]] double error_m(const Mapper& mapper, KeyframeId id) const {
    return test::distance_m(mapper.graph().keyframes().at(id).T_map_cam, walk_.T_first_cam(id));
  }

  test::SyntheticWalk walk_{{0.5, 0.5, 10}, 1500};
  std::vector<odometry::MapUpdate> closings_;
};

}  // namespace wardslam::graph
