#include <gmock/gmock.h>

#include "graph/synthetic_walk.h"
#include "wardslam/graph/mapper.h"

/// Rooms that look the same are the rule in a hospital.
namespace wardslam::graph {
namespace {

using test::makePose;
using test::SyntheticWalk;

GraphOptions fewAndFast() {
  GraphOptions options;
  options.bundle_adjustment.window = 4;
  options.bundle_adjustment.local_iterations = 4;
  options.place_recognition.min_keyframe_gap = 10;
  return options;
}

/// A room, a long corridor out and back, and a room 8 m from the first that looks the same to the last point.
class EqualRooms : public ::testing::Test {
 protected:
  static constexpr int kInRoom = 16;
  static constexpr int kOut = 25;
  static constexpr double kStep_m = 4.0;

  void insert(Mapper& mapper, std::shared_ptr<odometry::Keyframe> keyframe, const Eigen::Isometry3d& T_previous_cam) {
    keyframe->id = ++lastId_;
    keyframe->T_previous_cam = T_previous_cam;
    mapper.insert(keyframe);
  }

  std::shared_ptr<odometry::Keyframe> inCorridor() {
    auto keyframe = std::make_shared<odometry::Keyframe>();
    keyframe->submap = 1;
    keyframe->features = elsewhere_.lookElsewhere(60);
    for (std::size_t i = 0; i < keyframe->features.size(); ++i) keyframe->sightings.push_back({++lastPoint_, i});
    return keyframe;
  }

  void visitBoth(Mapper& mapper) {
    const auto room = walk_.walk(kInRoom);
    for (const auto& there : room) {
      insert(mapper, std::make_shared<odometry::Keyframe>(*there), there->T_previous_cam);
    }
    for (int i = 0; i < kOut; ++i) insert(mapper, inCorridor(), makePose({0.0, 0.0, kStep_m}));
    for (int i = 0; i < kOut - 2; ++i) insert(mapper, inCorridor(), makePose({0.0, 0.0, -kStep_m}));
    for (const auto& there : room) {
      auto here = std::make_shared<odometry::Keyframe>(*there);
      for (auto& sighting : here->sightings) sighting.point += 1000000;
      insert(mapper, here, there == room.front() ? Eigen::Isometry3d::Identity() : there->T_previous_cam);
    }
  }

  SyntheticWalk walk_{{0.5, 0.5, 10}, 1500};
  test::SyntheticWorld elsewhere_{1, 3};
  KeyframeId lastId_ = 0;
  PointId lastPoint_ = 2000000;
};

TEST_F(EqualRooms, AreNotTakenForEachOther) {
  Mapper mapper(fewAndFast(), {});
  visitBoth(mapper);
  EXPECT_TRUE(mapper.loops().empty());
  const auto& keyframes = mapper.graph().keyframes();
  const double between_m =
      test::distance_m(keyframes.at(kInRoom).T_map_cam, keyframes.at(lastId_ - kInRoom + 1).T_map_cam);
  EXPECT_NEAR(between_m, 8.0, 0.1);
}

TEST_F(EqualRooms, AreTakenForEachOtherWhereAnyDriftIsBelieved) {
  GraphOptions options = fewAndFast();
  options.loop_verification.gate_sigmas = 100.0;
  Mapper mapper(options, {});
  visitBoth(mapper);
  EXPECT_GE(mapper.loopsClosed(), 1U) << "nothing in the rooms tells them apart";
}

}  // namespace
}  // namespace wardslam::graph
