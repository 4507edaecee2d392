#include "wardslam/change/instance_motion.h"

#include <gtest/gtest.h>

#include "change/depth_scene.h"
#include "support/small_ward.h"

namespace wardslam::change {
namespace {

using Eigen::Vector3d;
using test::kFrameTime_s;
using test::poseAt;
using ward::kChair;
using ward::kPerson;

constexpr std::uint16_t kTheChair = 5;

class InstanceMotionTest : public testing::Test {
 protected:
  InstanceMotionTest() { scene_.add({kTheChair, kChair, {0.1, 0.0, 2.0}, 0.5, 0.5}); }

  /// So many images of things and a camera at these speeds (m/s), the poses told wrongly by `error_m`.
  double watch(int images, const Vector3d& chair, const Vector3d& camera = Vector3d::Zero(),
               const Vector3d& error_m = Vector3d::Zero()) {
    for (int i = 0; i < images; ++i) {
      motion_.update(scene_.frame(time_s_, camera_m_), poseAt(camera_m_ + error_m));
      time_s_ += kFrameTime_s;
      camera_m_ += camera * kFrameTime_s;
      scene_.thing(0).p_map_m += chair * kFrameTime_s;
    }
    return motion_.evidence(kTheChair);
  }

  const Vector3d rest_ = Vector3d::Zero();
  knowledge::MotionRules rules_{ward::graph(), core::LabelSpace::coco()};
  InstanceMotion motion_{rules_};
  test::DepthScene scene_;
  Vector3d camera_m_ = Vector3d::Zero();
  double time_s_ = 100.0;
};

TEST_F(InstanceMotionTest, NothingIsKnownAtFirst) {
  EXPECT_EQ(motion_.evidence(kTheChair), 0.0);
  EXPECT_EQ(watch(1, rest_), 0.0);
}

TEST_F(InstanceMotionTest, WhatRestsIsTheSurerTheLongerItDoes) {
  const double soon = watch(8, rest_);
  EXPECT_LT(soon, -0.2);
  const double later = watch(30, rest_);
  EXPECT_LT(later, -2.0);
  EXPECT_GE(later, -4.0) << "never beyond doubt";
}

TEST_F(InstanceMotionTest, WhatRestsIsToldFromACameraThatMoves) { EXPECT_LT(watch(30, rest_, {0.2, 0.1, 0.3}), -2.0); }

TEST_F(InstanceMotionTest, WhatIsCarriedAcrossMoves) { EXPECT_GT(watch(20, {0.4, 0, 0}), 1.5); }

TEST_F(InstanceMotionTest, WhatIsPushedAwayMoves) { EXPECT_GT(watch(20, {0, 0, 0.4}), 3.0); }

TEST_F(InstanceMotionTest, WhatComesNearerMoves) { EXPECT_GT(watch(20, {0, 0, -0.4}), 3.0); }

TEST_F(InstanceMotionTest, WhatGoesAlongWithTheCameraMoves) { EXPECT_GT(watch(20, {0.4, 0, 0}, {0.4, 0, 0}), 1.5); }

TEST_F(InstanceMotionTest, WhatIsSetDownRestsAfterASecond) {
  watch(20, {0.4, 0, 0});
  EXPECT_GT(watch(3, rest_), 0.0) << "just now";
  EXPECT_LT(watch(40, rest_), -2.0);
}

TEST_F(InstanceMotionTest, WhatBeginsToMoveIsSoonFoundOut) {
  watch(40, rest_);
  EXPECT_GT(watch(15, {0.5, 0, 0}), 0.0);
}

TEST_F(InstanceMotionTest, WhoeverPassesInFrontDoesNotMakeItMove) {
  scene_.add({6, kPerson, {-0.5, 0.0, 1.2}, 0.3, 1.2});
  for (int i = 0; i < 40; ++i) {
    watch(1, rest_);
    scene_.thing(1).p_map_m.x() += 1.0 * kFrameTime_s;
    EXPECT_LE(motion_.evidence(kTheChair), 0.0) << i;
  }
}

TEST_F(InstanceMotionTest, APoseThatJumpsMovesTheSceneTooAndProvesNothing) {
  watch(15, rest_);
  EXPECT_LT(watch(2, rest_, rest_, {0, 0, -0.3}), 0.0);
}

TEST_F(InstanceMotionTest, WithoutDepthNothingIsKnown) {
  for (int i = 0; i < 20; ++i) {
    core::Frame blind = scene_.frame(time_s_ += kFrameTime_s);
    blind.depth_m.setTo(0.0);
    motion_.update(blind, poseAt(rest_));
  }
  EXPECT_EQ(motion_.evidence(kTheChair), 0.0);
}

TEST_F(InstanceMotionTest, ImagesForgottenAreNotCompared) {
  watch(20, rest_);
  motion_.forgetImages();
  const double known = motion_.evidence(kTheChair);
  scene_.thing(0).p_map_m.x() += 0.5;  // unseen, while the camera was lost
  EXPECT_LT(watch(1, rest_), 0.0);
  EXPECT_NEAR(motion_.evidence(kTheChair), known, 0.2);
}

TEST_F(InstanceMotionTest, ThingsOutOfSightAreForgotten) {
  watch(20, rest_);
  core::Frame empty = test::DepthScene().frame(time_s_);
  motion_.update(empty, poseAt(rest_));
  EXPECT_EQ(motion_.evidence(kTheChair), 0.0);
}

}  // namespace
}  // namespace wardslam::change
