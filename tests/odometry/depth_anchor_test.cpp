#include "depth_anchor.h"

#include <gtest/gtest.h>

#include "odometry/odometry_fixture.h"
#include "odometry/rendered_planes.h"

namespace wardslam::odometry {
namespace {

using test::moved;
using test::RenderedPlanes;

/// A camera that goes ahead and turns in a room whose key points are there or not, as the test wants.
class DepthAnchorTest : public ::testing::Test {
 protected:
  static Eigen::Isometry3d truth(int image) { return moved({0.01 * image, 0, 0.01 * image}, {0, 0.004 * image, 0}); }

  OdometryResult look(int image, bool hasKeypoints, RenderedPlanes& planes) {
    const core::Features features = hasKeypoints ? world_.look(truth(image), kNoise) : world_.lookElsewhere(20);
    return odometry_.track(image / 10.0, kCamera, features, planes.look(truth(image), 1.0));
  }

  const core::CameraModel kCamera;
  SyntheticWorld world_{1500};
  Odometry odometry_{OdometryOptions{}};
  RenderedPlanes room_{RenderedPlanes::room(5.0)};
};

TEST_F(DepthAnchorTest, TwoSecondsWithoutKeyPointsInABareRoom) {
  for (int image = 0; image < 5; ++image) {
    const auto result = look(image, true, room_);
    ASSERT_TRUE(result.hasPose());
    EXPECT_FALSE(result.isHeldByDepth) << "there is no need";
  }
  for (int image = 5; image < 25; ++image) {
    const auto result = look(image, false, room_);
    ASSERT_TRUE(result.hasPose()) << image;
    EXPECT_TRUE(result.isHeldByDepth);
    EXPECT_LT(distance_m(result.T_map_cam, truth(image)), 0.015) << image;
    EXPECT_LT(angle_deg(result.T_map_cam, truth(image)), 0.3) << image;
    ASSERT_TRUE(result.covariance);
    EXPECT_LT(std::sqrt((*result.covariance)(0, 0)), 0.02);
  }
  const auto back = look(25, true, room_);
  EXPECT_FALSE(back.isHeldByDepth) << "known points are found where depth led";
  EXPECT_GT(back.inliers, 100);
  EXPECT_LT(distance_m(back.T_map_cam, truth(25)), 0.01);
}

TEST_F(DepthAnchorTest, AlongABareCorridorItIsUnsureAndThenLost) {
  RenderedPlanes corridor(RenderedPlanes::corridor());
  for (int image = 0; image < 5; ++image) ASSERT_TRUE(look(image, true, corridor).hasPose());
  const auto first = look(5, false, corridor);
  ASSERT_TRUE(first.isHeldByDepth);
  EXPECT_LT(distance_m(first.T_map_cam, truth(5)), 0.03) << "it goes on as it went";
  const auto second = look(6, false, corridor);
  ASSERT_TRUE(second.isHeldByDepth);
  const auto worst_m = [](const OdometryResult& result) {
    return std::sqrt(result.covariance->topLeftCorner<3, 3>().diagonal().maxCoeff());
  };
  EXPECT_GT(worst_m(second), worst_m(first));
  bool isLost = false;
  for (int image = 7; image < 20 && !isLost; ++image) isLost = !look(image, false, corridor).hasPose();
  EXPECT_TRUE(isLost) << "nobody can say where along the corridor it is";
}

TEST_F(DepthAnchorTest, WheelsThatLieMakeItLessSureWithEveryImage) {
  RenderedPlanes corridor(RenderedPlanes::corridor());
  for (int image = 0; image < 5; ++image) ASSERT_TRUE(look(image, true, corridor).hasPose());
  MotionPrior wheels;
  wheels.covariance = 1e-6 * PoseCovariance::Identity();
  wheels.T_previous_now = truth(5).inverse() * truth(6);
  double before = 0.0;
  for (int image = 5; image < 15; ++image) {
    const auto result =
        odometry_.track(image / 10.0, kCamera, world_.lookElsewhere(20), corridor.look(truth(image), 1.0), wheels);
    ASSERT_TRUE(result.isHeldByDepth) << image;
    const double now = worstSigma_m(*result.covariance);
    EXPECT_GT(now, before) << image;
    before = now;
  }
  EXPECT_GT(before, 0.0028) << "ten steps of a millimetre each";
}

TEST_F(DepthAnchorTest, InTheDarkItBeginsWithSurfacesAlone) {
  int keyframes = 0;
  for (int image = 0; image < 60; ++image) {  // 0.83 m, 0.24 rad
    const auto result = look(image, false, room_);
    ASSERT_EQ(result.state, State::Ok) << image;
    EXPECT_LT(distance_m(result.T_map_cam, truth(image)), 0.02) << image;
    keyframes += result.keyframe ? 1 : 0;
  }
  EXPECT_EQ(keyframes, 2) << "the first, and one half a metre on, for what the map sees from there";
  const auto lit = look(60, true, room_);
  ASSERT_TRUE(lit.keyframe) << "with the light come points to know";
  EXPECT_GT(lit.keyframe->sightings.size(), 100U);
  const auto next = look(61, true, room_);
  EXPECT_FALSE(next.isHeldByDepth);
  EXPECT_GT(next.inliers, 100);
  EXPECT_LT(distance_m(next.T_map_cam, truth(61)), 0.02);
}

TEST_F(DepthAnchorTest, WhereSurfacesLeaveADirectionOpenItDoesNotBeginInTheDark) {
  RenderedPlanes corridor(RenderedPlanes::corridor());
  EXPECT_EQ(look(0, false, corridor).state, State::Initialising);
  const DepthImage none;
  EXPECT_EQ(odometry_.track(1.0, kCamera, world_.lookElsewhere(20), none).state, State::Initialising);
}

TEST_F(DepthAnchorTest, AfterAGapSurfacesAloneAreNotBelieved) {
  for (int image = 0; image < 5; ++image) ASSERT_TRUE(look(image, true, room_).hasPose());
  const auto soon = odometry_.track(0.9, kCamera, world_.lookElsewhere(20), room_.look(truth(9), 1.0));
  EXPECT_TRUE(soon.isHeldByDepth) << "it cannot have gone far";
  const auto late = odometry_.track(2.1, kCamera, world_.lookElsewhere(20), room_.look(truth(12), 1.0));
  EXPECT_EQ(late.state, State::Lost) << "it may have gone a metre, and floor and walls lie there, too";
}

TEST_F(DepthAnchorTest, NothingHoldsACoveredLens) {
  for (int image = 0; image < 5; ++image) ASSERT_TRUE(look(image, true, room_).hasPose());
  const DepthImage covered{cv::Mat(480, 640, CV_32FC1, cv::Scalar(0)), {}};
  EXPECT_EQ(odometry_.track(0.5, kCamera, world_.lookElsewhere(20), covered).state, State::Lost);
}

}  // namespace
}  // namespace wardslam::odometry
