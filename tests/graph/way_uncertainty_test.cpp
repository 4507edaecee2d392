#include "way_uncertainty.h"

#include <gtest/gtest.h>

#include "graph/hand_made_keyframe.h"
#include "graph/mapper_walk.h"
#include "graph/synthetic_walk.h"

namespace wardslam::graph {
namespace {

using test::makePose;
using test::SyntheticWalk;

class WayUncertaintyTest : public ::testing::Test {
 protected:
  /// Keyframes 1 to `count`, a metre apart along x; nothing is seen twice.
  void goStraight(KeyframeId count, std::uint32_t submap = 1) {
    for (KeyframeId id = 1; id <= count; ++id) {
      auto keyframe = std::make_shared<odometry::Keyframe>();
      keyframe->id = id;
      keyframe->submap = submap;
      if (id > 1) keyframe->T_previous_cam = makePose({1, 0, 0});
      graph_.insert(keyframe);
    }
  }

  LoopVerificationOptions options_;
  KeyframeGraph graph_;
};

TEST_F(WayUncertaintyTest, GrowsWithTheWayAndMoreAcrossIt) {
  options_.position_drift = 0.02;
  options_.rotation_drift_rad = 0.01;
  goStraight(3);
  const auto found = uncertaintyOfWay(graph_, {}, 1, 3, options_);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->rotation_rad2, 2 * 1e-4, 1e-12);
  EXPECT_NEAR(found->position_m2(0, 0), 2 * 4e-4, 1e-12);
  EXPECT_NEAR(found->position_m2(1, 1), 2 * 4e-4 + 1e-4 * (1 * 1 + 2 * 2), 1e-12) << "turned 1 m and 2 m from the end";
  EXPECT_NEAR(found->position_m2(2, 2), found->position_m2(1, 1), 1e-12);
  EXPECT_NEAR(found->position_m2(0, 1), 0.0, 1e-12);
}

TEST_F(WayUncertaintyTest, GoesByALoopWhereThatIsShorter) {
  goStraight(40);
  graph_.setPose(40, makePose({0, 1, 0}));
  const Loop loop{1, 40, makePose({0, 1, 0}), 100, {}, {1}};
  const auto found = uncertaintyOfWay(graph_, {loop}, 1, 40, options_);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->rotation_rad2, options_.rotation_drift_rad * options_.rotation_drift_rad, 1e-12) << "one metre";
}

TEST_F(WayUncertaintyTest, WhatIsSettledHasNotDrifted) {
  for (const KeyframeId id : {1, 2, 3}) {
    auto keyframe = std::make_shared<odometry::Keyframe>();
    keyframe->id = id;
    keyframe->submap = 1;
    keyframe->T_map_cam = makePose({10.0 * static_cast<double>(id), 0, 0});
    graph_.restore(keyframe, {});
  }
  for (const KeyframeId id : {4, 5}) {
    auto keyframe = std::make_shared<odometry::Keyframe>();
    keyframe->id = id;
    keyframe->submap = 1;
    keyframe->T_previous_cam = makePose({1, 0, 0});
    graph_.insert(keyframe);
  }
  const double step_rad2 = options_.rotation_drift_rad * options_.rotation_drift_rad;
  EXPECT_NEAR(uncertaintyOfWay(graph_, {}, 1, 5, options_)->rotation_rad2, 22 * step_rad2, 1e-12);
  EXPECT_NEAR(uncertaintyOfWay(graph_, {}, 1, 5, options_, Drifting::Unsettled)->rotation_rad2, 2 * step_rad2, 1e-12);
  EXPECT_EQ(uncertaintyOfWay(graph_, {}, 1, 3, options_, Drifting::Unsettled)->rotation_rad2, 0.0);
}

TEST_F(WayUncertaintyTest, BetweenPiecesNothingIsKnown) {
  goStraight(2);
  auto anew = std::make_shared<odometry::Keyframe>();
  anew->id = 3;
  anew->submap = 2;
  graph_.insert(anew);
  EXPECT_FALSE(uncertaintyOfWay(graph_, {}, 1, 3, options_));
}

TEST(WayUncertainty, ExplainsWhatLiesWithinTheGate) {
  LoopVerificationOptions options;
  options.gate_sigmas = 3.0;
  options.min_drift_m = 0.0;
  options.min_drift_rad = 0.0;
  WayUncertainty uncertainty;
  uncertainty.position_m2 = Eigen::Vector3d(0.01, 0.04, 0.01).asDiagonal();
  uncertainty.rotation_rad2 = 1e-4;
  EXPECT_TRUE(uncertainty.explains({0.29, 0, 0}, 0.029, options));
  EXPECT_FALSE(uncertainty.explains({0.31, 0, 0}, 0.0, options));
  EXPECT_TRUE(uncertainty.explains({0, 0.59, 0}, 0.0, options));
  EXPECT_FALSE(uncertainty.explains({0, 0, 0}, 0.031, options));
  options.min_drift_m = 0.4;
  EXPECT_TRUE(uncertainty.explains({0.31, 0, 0}, 0.0, options)) << "that little is always believed";
}

/// Rooms that look the same are the rule in a hospital.
/// A room, a long corridor out and back, and a room 8 m from the first that looks the same to the last point.
class EqualRooms : public ::testing::Test {
 protected:
  static constexpr int kInRoom = 16;
  static constexpr int kOut = 25;
  static constexpr double kStep_m = 4.0;

  void insert(Mapper& mapper, std::shared_ptr<odometry::Keyframe> keyframe,
              const std::optional<Eigen::Isometry3d>& T_previous_cam) {
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
