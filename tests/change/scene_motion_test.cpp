#include "wardslam/change/scene_motion.h"

#include <gtest/gtest.h>

#include "change/moving_scene.h"
#include "evidence.h"
#include "free_space.h"
#include "point_tracker.h"

namespace wardslam::change {
namespace {

using test::kFrameTime_s;
using test::Scene;

struct Shares {
  double inside = 0.0;   ///< Of the tracks on the person.
  double outside = 0.0;  ///< Of the others.
};

/// Of the tracks older than five images: which share is thought to move, on the person and beside him.
Shares movingShares(const SceneMotion& motion, const cv::Rect2d& person) {
  int counts[2][2] = {{0, 0}, {0, 0}};
  for (const Track& track : motion.tracks()) {
    const cv::Point2d px(track.raw_px);
    const bool isNear = cv::Rect2d(person.x - 20, person.y - 20, person.width + 40, person.height + 40).contains(px);
    const bool isOn = cv::Rect2d(person.x + 12, person.y + 12, person.width - 24, person.height - 24).contains(px);
    if (track.positions.size() < 6 || (isNear && !isOn)) continue;
    ++counts[isOn][track.logOdds > 1.0];
  }
  const auto share = [](const int(&c)[2]) { return c[0] + c[1] == 0 ? -1.0 : double(c[1]) / (c[0] + c[1]); };
  return {share(counts[1]), share(counts[0])};
}

class SceneMotionTest : public testing::Test {
 protected:
  SceneMotionTest() { scene_.add(test::person()); }

  /// Twenty images of a camera and a person at these speeds (m/s).
  void walk(const Eigen::Vector3d& camera, const Eigen::Vector3d& person, int images = 20) {
    for (int i = 0; i < images; ++i) {
      motion_.update(scene_.frame(time_s_, position_));
      box_ = scene_.board(0).boxSeenFrom(position_);
      time_s_ += kFrameTime_s;
      position_ += camera * kFrameTime_s;
      scene_.board(0).p_map_m += person * kFrameTime_s;
    }
  }

  /// Fourteen images of a camera that turns by 40 degrees at 86 degrees (about 800 px) a second.
  void turn(const Eigen::Vector3d& person) {
    constexpr double kSpeed_rad = 1.5;  // per second
    for (int i = 0; i < 14; ++i) {
      motion_.update(scene_.frame(time_s_, test::looking(position_, -0.35 + kSpeed_rad * time_s_)));
      time_s_ += kFrameTime_s;
      scene_.board(0).p_map_m += person * kFrameTime_s;
    }
  }

  Scene scene_;
  SceneMotion motion_{SceneMotionOptions{}};
  Eigen::Vector3d position_ = Eigen::Vector3d::Zero();
  cv::Rect2d box_;
  double time_s_ = 0.0;
};

TEST_F(SceneMotionTest, WhileNothingMovesNothingIsFound) {
  walk({0, 0, 0}, {0, 0, 0});
  EXPECT_TRUE(motion_.isTrusted());
  EXPECT_EQ(movingShares(motion_, box_).inside, 0.0);
  EXPECT_EQ(movingShares(motion_, box_).outside, 0.0);
  EXPECT_EQ(cv::countNonZero(motion_.space() == static_cast<int>(Seen::Through)), 0);
}

TEST_F(SceneMotionTest, AMovingCameraMakesNoMotion) {
  walk({0.4, 0.1, 0.2}, {0, 0, 0});
  EXPECT_TRUE(motion_.isTrusted());
  EXPECT_LT(movingShares(motion_, box_).inside, 0.05);
  EXPECT_LT(movingShares(motion_, box_).outside, 0.05);
}

TEST_F(SceneMotionTest, AFastTurnMakesNoMotion) {
  turn({0, 0, 0});
  EXPECT_TRUE(motion_.isTrusted());
  int moving = 0;
  for (const Track& track : motion_.tracks()) moving += track.logOdds > 1.0 ? 1 : 0;
  EXPECT_EQ(moving, 0) << "of " << motion_.tracks().size();
  EXPECT_LT(cv::countNonZero(motion_.space() == static_cast<int>(Seen::Through)), 160 * 120 / 100);
}

TEST_F(SceneMotionTest, APersonWalkingAcrossIsFound) {
  walk({0, 0, 0}, {0.5, 0, 0});
  EXPECT_GT(movingShares(motion_, box_).inside, 0.9);
  EXPECT_LT(movingShares(motion_, box_).outside, 0.05);
}

TEST_F(SceneMotionTest, APersonComingCloserIsFoundFromAMovingCamera) {
  walk({-0.3, 0, 0.1}, {0, 0, -0.5});
  EXPECT_GT(movingShares(motion_, box_).inside, 0.9);
  EXPECT_LT(movingShares(motion_, box_).outside, 0.05);
}

TEST_F(SceneMotionTest, SeesWhereTheSurfaceHasCome) {
  walk({0, 0, 0}, {0.5, 0, 0});
  // In half a second he came 0.25 m or 83 px to the right, of which the edge takes about ten.
  const cv::Mat appeared = motion_.space() == static_cast<int>(Seen::Through);
  const double columns = 83.0 / DepthGrid::kStep_px;
  const double rows = box_.height / DepthGrid::kStep_px;
  EXPECT_NEAR(cv::countNonZero(appeared) / (columns * rows), 0.9, 0.15);
  const cv::Rect front(static_cast<int>(box_.br().x) / 4 - 22, static_cast<int>(box_.y) / 4, 24,
                       static_cast<int>(rows) + 1);
  EXPECT_GT(cv::countNonZero(appeared(front)), 0.95 * cv::countNonZero(appeared));
}

TEST_F(SceneMotionTest, APersonWithoutDepthIsFoundByHisLooks) {
  for (int i = 0; i < 20; ++i) {
    core::Frame frame = scene_.frame(time_s_, position_);
    frame.depth_m.setTo(0, frame.depth_m < 2.0);
    motion_.update(frame);
    box_ = scene_.board(0).boxSeenFrom(position_);
    time_s_ += kFrameTime_s;
    scene_.board(0).p_map_m.x() += 0.5 * kFrameTime_s;
  }
  EXPECT_GT(movingShares(motion_, box_).inside, 0.9);
  EXPECT_LT(movingShares(motion_, box_).outside, 0.05);
}

TEST_F(SceneMotionTest, WhoStopsIsStaticAfterAWhile) {
  walk({0, 0, 0}, {0.5, 0, 0});
  walk({0, 0, 0}, {0, 0, 0}, 40);
  EXPECT_LT(movingShares(motion_, box_).inside, 0.05);
}

TEST_F(SceneMotionTest, KnownMoversHaveNoSayAboutTheCamera) {
  // He fills most of the image, walks from the first moment on, and the camera stands still.
  scene_.board(0).width_m = 1.6;
  scene_.board(0).height_m = 1.3;
  scene_.board(0).texture = test::texture(3, {800, 650});
  for (int i = 0; i < 15; ++i) {
    const core::Frame frame = scene_.frame(time_s_, position_);
    const cv::Mat person = frame.depth_m < 2.0;
    motion_.update(frame, person);
    time_s_ += kFrameTime_s;
    scene_.board(0).p_map_m.x() += 0.4 * kFrameTime_s;
  }
  box_ = scene_.board(0).boxSeenFrom(position_);
  EXPECT_TRUE(motion_.isTrusted());
  EXPECT_GT(movingShares(motion_, box_).inside, 0.9);
}

TEST_F(SceneMotionTest, BlindItFindsNothing) {
  walk({0, 0, 0}, {0.5, 0, 0}, 1);
  for (int i = 0; i < 10; ++i) {
    core::Frame dark = scene_.frame(time_s_ += kFrameTime_s, position_);
    dark.gray.setTo(0);
    motion_.update(dark);
  }
  EXPECT_FALSE(motion_.isTrusted());
  EXPECT_TRUE(motion_.isAtLoss());
  for (const Track& track : motion_.tracks()) EXPECT_EQ(track.logOdds, 0.0);
}

TEST_F(SceneMotionTest, StartsAgainAfterAGapOrAStepBackInTime) {
  walk({0, 0, 0}, {0.5, 0, 0});
  time_s_ += 10.0;
  walk({0, 0, 0}, {0, 0, 0}, 1);
  EXPECT_FALSE(motion_.isTrusted()) << "nothing to compare with";
  EXPECT_FALSE(motion_.isAtLoss()) << "which is no trouble";
  time_s_ = 0.0;
  walk({0, 0, 0}, {0, 0, 0}, 1);
  EXPECT_FALSE(motion_.isTrusted());
}

}  // namespace
}  // namespace wardslam::change
