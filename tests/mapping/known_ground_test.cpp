#include "known_ground.h"

#include <gtest/gtest.h>

#include "mapping/scene.h"

namespace wardslam::mapping {
namespace {

PlacedKeyframe keyframeAt(double x_m, std::uint32_t piece) {
  PlacedKeyframe keyframe;
  keyframe.piece = piece;
  keyframe.T_map_cam = scene::cameraAt({x_m, 0, 1.0});
  return keyframe;
}

class KnownGroundTest : public ::testing::Test {
 protected:
  KnownGroundTest() {
    keyframes_[1] = keyframeAt(0.0, 0);
    keyframes_[1].ground = core::GroundPlane::atZero(keyframes_[1].T_map_cam);
    keyframes_[2] = keyframeAt(1.0, 0);
    keyframes_[3] = keyframeAt(1.5, 7);
    keyframes_[3].ground = core::GroundPlane::atZero(keyframes_[3].T_map_cam);
  }
  std::map<odometry::KeyframeId, PlacedKeyframe> keyframes_;
};

TEST_F(KnownGroundTest, IsThatOfTheNearestOfThePieceThatSawOne) {
  const auto known = groundKnownAt(keyframes_, keyframeAt(2.0, 0));
  ASSERT_TRUE(known);
  EXPECT_NEAR(known->distance_m, 2.0, 1e-9) << "neither that which saw none nor that of another piece";
  EXPECT_NEAR(known->plane.height_m, 1.0, 1e-9);
  EXPECT_FALSE(groundKnownAt(keyframes_, keyframeAt(2.0, 1)));
}

TEST_F(KnownGroundTest, IsExpectedLessSurelyFartherAway) {
  const auto here = keyframeAt(2.0, 0);
  const auto expected = expectedAt(here, groundKnownAt(keyframes_, here));
  EXPECT_NEAR(expected.height_m.value_or(0.0), 1.0, 1e-9);
  EXPECT_NEAR(expected.heightTolerance_m, 0.06 + 2.0 * 0.15, 1e-9);
  const auto far = keyframeAt(20.0, 0);
  EXPECT_FALSE(expectedAt(far, groundKnownAt(keyframes_, far)).height_m);
}

TEST_F(KnownGroundTest, WithoutAnyUpIsWhereTheMapHasIt) {
  const auto expected = expectedAt(keyframeAt(0.0, 1), std::nullopt);
  EXPECT_TRUE(expected.up_cam.isApprox(Eigen::Vector3d(0, -1, 0), 1e-9));
  EXPECT_FALSE(expected.height_m);
}

TEST_F(KnownGroundTest, IsWhatAKeyframeCameWith) {
  auto here = keyframeAt(2.0, 0);
  here.ground = core::GroundPlane{-Eigen::Vector3d::UnitY(), 0.7, Eigen::Matrix3d::Identity()};
  View view;  // shows nothing
  view.camera = scene::camera();
  view.depth_m = cv::Mat(view.camera.height_px, view.camera.width_px, CV_32FC1, cv::Scalar(0));
  const StandingGround ground = lookAtGround(view, keyframes_, here);
  EXPECT_TRUE(ground.isSeen);
  EXPECT_EQ(ground.plane.height_m, 0.7);
  EXPECT_TRUE(here.ground);
}

}  // namespace
}  // namespace wardslam::mapping
