#include "doubles.h"

#include <gmock/gmock.h>

#include <cmath>
#include <memory>
#include <opencv2/core.hpp>

#include "graph/mapper_walk.h"

namespace wardslam::graph {
namespace {

using testing::IsEmpty;

/// A round wall around the way: it looks the same from every step.
std::shared_ptr<const odometry::DepthView> wall() {
  constexpr double kRadius_m = 5.0;  // the camera goes round a metre from the middle
  const core::CameraModel camera = test::SyntheticWorld::camera();
  odometry::DepthImage image;
  image.depth_m.create(camera.height_px, camera.width_px, CV_32FC1);
  for (int u = 0; u < camera.width_px; ++u) {
    const double slope = (u - camera.cx_px) / camera.fx_px;
    const double square = 1.0 + slope * slope;
    image.depth_m.col(u) = (std::sqrt(1.0 + square * (kRadius_m * kRadius_m - 1.0)) - 1.0) / square;
  }
  return std::make_shared<odometry::DepthView>(odometry::makeDepthView(image));
}

/// A room seen all around, and a part of another that is equal to it.
class DoublesTest : public MapperWalk {
 protected:
  static constexpr int kSeenOfTheOther = 8;
  enum class Rest { Unseen, LooksOtherwise };

  std::shared_ptr<odometry::Keyframe> step(const Eigen::Isometry3d& slip = Eigen::Isometry3d::Identity()) {
    auto keyframe = walk_.step(slip);
    keyframe->depth = wall_;
    return keyframe;
  }

  /// Of a map in which the other room lies `apart_m` away.
  SavedGraph mapOfBoth(double apart_m, Rest rest = Rest::Unseen) {
    GraphOptions options = fewAndFast();
    options.close_loops = options.cull_keyframes = false;
    Mapper earlier(options, {});
    for (int i = 0; i < kRound; ++i) insert(earlier, step());
    walk_.forgetPoints();
    insert(earlier, step(test::makePose({apart_m, 0, 0})));
    for (int i = 1; i < kSeenOfTheOther; ++i) insert(earlier, step());
    walk_.forgetPoints();
    for (int i = kSeenOfTheOther; i < kRound && rest == Rest::LooksOtherwise; ++i) {
      const auto keyframe = step();
      cv::bitwise_not(keyframe->features.descriptors, keyframe->features.descriptors);
      insert(earlier, keyframe);
    }
    return save(earlier.graph());
  }

  std::vector<Loop> doublesOfKeyframe(KeyframeId id, double apart_m) {
    const SavedGraph saved = mapOfBoth(apart_m);
    const GraphOptions options = fewAndFast();
    KeyframeGraph graph;
    PlaceRecognition places(options.place_recognition);
    for (const auto& keyframe : saved.keyframes) {
      graph.restore(keyframe, saved.p_map_m);
      places.add(keyframe->id, keyframe->features.descriptors);
    }
    places.build();
    return doublesOf(graph, id, places, LoopVerification(options.loop_verification, {}, {}), options.place_recognition);
  }

  /// Switched off and carried to where the camera looks as it did at this step of the first round.
  void goOnFrom(int from, Mapper& mapper) {
    walk_.loseTrack();
    for (auto i = static_cast<int>(mapper.graph().keyframes().size()); i % kRound != from; ++i) walk_.skip();
    for (int i = 0; i < 4; ++i) insert(mapper, step());
  }

 private:
  const std::shared_ptr<const odometry::DepthView> wall_ = wall();
};

TEST_F(DoublesTest, EachHasADoubleInTheOther) {
  const auto doubles = doublesOfKeyframe(5, 12.0);
  ASSERT_FALSE(doubles.empty());
  for (const Loop& look : doubles) {
    EXPECT_EQ(look.newer, 5U);
    EXPECT_GT(look.older, KeyframeId{kRound});
  }
}

TEST_F(DoublesTest, WhatTheOtherDoesNotShowHasNone) { EXPECT_THAT(doublesOfKeyframe(22, 12.0), IsEmpty()); }

TEST_F(DoublesTest, WhatIsNearIsNoDouble) { EXPECT_THAT(doublesOfKeyframe(5, 1.0), IsEmpty()); }

TEST_F(DoublesTest, NobodyIsJoinedWhereTheOtherIsNotKnownToLookOtherwise) {
  Mapper mapper(fewAndFast(), {});
  mapper.restore(mapOfBoth(12.0));
  goOnFrom(20, mapper);  // the first room, or what nobody saw yet of the other
  EXPECT_EQ(mapper.submapsJoined(), 0U);
  EXPECT_FALSE(mapper.settle());
}

TEST_F(DoublesTest, OneIsJoinedWhereTheOtherLooksOtherwise) {
  Mapper mapper(fewAndFast(), {});
  mapper.restore(mapOfBoth(12.0, Rest::LooksOtherwise));
  goOnFrom(20, mapper);
  EXPECT_EQ(mapper.submapsJoined(), 1U);
}

}  // namespace
}  // namespace wardslam::graph
