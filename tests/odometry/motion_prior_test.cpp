#include "wardslam/odometry/motion_prior.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "odometry/synthetic_world.h"
#include "wardslam/odometry/odometry.h"

namespace wardslam::odometry {
namespace {

using test::SyntheticWorld;

constexpr int kImages = 60;

Eigen::Isometry3d pose(const Eigen::Vector3d& t, double yaw_rad) {
  Eigen::Isometry3d T(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
  T.translation() = t;
  return T;
}

/// A camera 2 m ahead of the base swings by 2 m per radian to the left.
TEST(MotionPrior, WhatTurnsTheBaseSwingsTheCameraInFrontOfIt) {
  MotionPrior ofBase;
  ofBase.T_previous_now = pose({0.0, 0.0, 0.0}, 0.1);
  ofBase.covariance = 1e-6 * PoseCovariance::Identity();
  ofBase.covariance(5, 5) = 0.01;
  const Eigen::Isometry3d T_base_cam = pose({2.0, 0.0, 0.0}, 0.0);
  const MotionPrior ofCamera = transformed(ofBase, T_base_cam);
  EXPECT_NEAR(ofCamera.T_previous_now.translation().y(), 2.0 * std::sin(0.1), 1e-12);
  EXPECT_NEAR(ofCamera.T_previous_now.translation().x(), 2.0 * std::cos(0.1) - 2.0, 1e-12);
  EXPECT_NEAR(ofCamera.covariance(1, 1), 4.0 * 0.01, 1e-5);
  EXPECT_NEAR(ofCamera.covariance(1, 5), 2.0 * 0.01, 1e-5) << "and these go together";
  EXPECT_NEAR(ofCamera.covariance(5, 5), 0.01, 1e-9);
}

TEST(MotionPrior, IsWrittenInTheFrameOfTheBodyAsItStandsThen) {
  MotionPrior straight;
  straight.covariance = 1e-6 * PoseCovariance::Identity();
  straight.covariance(0, 0) = 0.04;  // ahead
  MotionPrior turn;
  turn.T_previous_now = pose({0.0, 0.0, 0.0}, M_PI / 2.0);
  turn.covariance = 1e-6 * PoseCovariance::Identity();
  const MotionPrior both = composed(straight, turn);
  EXPECT_NEAR(both.covariance(1, 1), 0.04, 1e-5) << "what was ahead is to the right now";
  EXPECT_NEAR(both.covariance(0, 0), 2e-6, 1e-9);
}

TEST(MotionPrior, OneAfterAnother) {
  MotionPrior metre;
  metre.T_previous_now = pose({1.0, 0.0, 0.0}, M_PI / 2.0);
  metre.covariance = 0.01 * PoseCovariance::Identity();
  const MotionPrior both = composed(metre, metre);
  EXPECT_TRUE(both.T_previous_now.translation().isApprox(Eigen::Vector3d(1.0, 1.0, 0.0), 1e-12));
  // Of the first, what it turned wrongly about z: 1 m per rad to the left of its own, 0.01 more there.
  EXPECT_NEAR(both.covariance(5, 5), 0.02, 1e-12);
  EXPECT_NEAR(both.covariance(0, 0), 0.03, 1e-12);
  EXPECT_NEAR(both.covariance(1, 1), 0.02, 1e-12);
}

TEST(MotionPrior, IsUsableWithNumbersAndACovarianceAlone) {
  MotionPrior prior;
  EXPECT_TRUE(isUsable(prior));
  prior.covariance(2, 2) = 0.0;
  EXPECT_FALSE(isUsable(prior));
  prior.covariance(2, 2) = -1.0;
  EXPECT_FALSE(isUsable(prior));
  prior.covariance(2, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(isUsable(prior));
  prior.covariance = PoseCovariance::Identity();
  prior.T_previous_now.translation().x() = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(isUsable(prior));
}

Eigen::Isometry3d truth(int image) {
  return SyntheticWorld::T_world_cam(0, kImages).inverse() * SyntheticWorld::T_world_cam(image, kImages);
}

double distance_m(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return (a.translation() - b.translation()).norm();
}

/// A camera on a known path, and what moves it tells how.
class TrackingByMotionPriors : public ::testing::Test {
 protected:
  [[nodiscard]] core::Features look(int image) {
    return world_.look(SyntheticWorld::T_world_cam(image, kImages), {0.5, 1.0, 8});
  }
  OdometryResult track(const core::Features& features, const std::optional<MotionPrior>& motion = {},
                       const Placement& placeAnew = {}) {
    return odometry_.track(stamp_s_ += 1.0 / 30, SyntheticWorld::camera(), features, {}, motion, placeAnew);
  }
  void trackUntil(int image) {
    for (int i = 0; i <= image; ++i) track(look(i));
  }

  static OdometryOptions options() {
    OdometryOptions options;
    options.max_lost_frames = 5;
    return options;
  }

  SyntheticWorld world_;
  Odometry odometry_{options()};
  double stamp_s_ = 0;
};

/// How the camera moved between two images of the path, a little wrong.
MotionPrior motionBetween(int from, int to) {
  MotionPrior motion;
  motion.T_previous_now = truth(from).inverse() * truth(to) * Eigen::Translation3d(0.002, -0.001, 0.001);
  motion.covariance = 1e-5 * PoseCovariance::Identity();
  return motion;
}

/// Thirty images are left out: farther than any search from where constant velocity leads. Nobody recognises anything
/// by its looks here.
TEST_F(TrackingByMotionPriors, LeadsWhereConstantVelocityDoesNot) {
  OdometryOptions nearOnly = options();
  nearOnly.relocalisation.min_found_fraction = 1.0;
  for (const bool isLed : {true, false}) {
    Odometry odometry{nearOnly};
    for (int i = 0; i <= 10; ++i) odometry.track(i / 30.0, SyntheticWorld::camera(), look(i));
    const auto motion = isLed ? std::optional(motionBetween(10, 40)) : std::nullopt;
    const auto result = odometry.track(11 / 30.0, SyntheticWorld::camera(), look(40), {}, motion);
    EXPECT_EQ(result.hasPose(), isLed);
    if (isLed) {
      EXPECT_LT(distance_m(result.T_map_cam, truth(40)), 0.01);
    }
  }
}

TEST_F(TrackingByMotionPriors, TellsHowSureAPoseIs) {
  const auto first = track(look(0));
  ASSERT_TRUE(first.covariance);
  EXPECT_EQ(first.covariance->norm(), 0.0) << "the map begins there";
  const auto second = track(look(1));
  ASSERT_TRUE(second.covariance);
  const double sigma_m = std::sqrt(second.covariance->topLeftCorner<3, 3>().trace());
  EXPECT_GT(sigma_m, 1e-4);
  EXPECT_LT(sigma_m, 0.01);
  stamp_s_ += 1.0;
  EXPECT_FALSE(track({}).covariance) << "nobody knows";
}

TEST_F(TrackingByMotionPriors, WithoutMotionsACameraThatIsCoveredGoesOnForAMoment) {
  trackUntil(19);
  const auto last = track(look(20));
  const Eigen::Isometry3d T_map_keyframe = last.T_map_cam * last.T_keyframe_cam.inverse();
  double before_m = 0.0;
  for (int image = 21; image <= 24; ++image) {
    const auto lost = track({});
    EXPECT_EQ(lost.state, State::Lost);
    EXPECT_LT(distance_m(lost.T_map_cam, truth(image)), 0.02) << image;
    ASSERT_TRUE(lost.covariance);
    EXPECT_GT(worstSigma_m(*lost.covariance), before_m) << "ever less sure";
    before_m = worstSigma_m(*lost.covariance);
    EXPECT_TRUE((lost.T_map_cam * lost.T_keyframe_cam.inverse()).isApprox(T_map_keyframe, 1e-9)) << image;
  }
}

TEST_F(TrackingByMotionPriors, WhileNothingIsSeenMotionsAddUpAndTheirErrorsToo) {
  trackUntil(20);
  for (int image = 21; image <= 23; ++image) {
    const auto lost = track({}, motionBetween(image - 1, image));
    EXPECT_EQ(lost.state, State::Lost);
    EXPECT_LT(distance_m(lost.T_map_cam, truth(image)), 0.02) << image;
    ASSERT_TRUE(lost.covariance);
    EXPECT_GT((*lost.covariance)(0, 0), 0.99e-5 * (image - 20)) << image;
  }
  const auto found = track(look(24), motionBetween(23, 24));
  ASSERT_EQ(found.state, State::Ok);
  EXPECT_LT(distance_m(found.T_map_cam, truth(24)), 0.01);
}

TEST_F(TrackingByMotionPriors, AGapInTheMotionsIsNotBridged) {
  trackUntil(20);
  EXPECT_TRUE(track({}, motionBetween(20, 21)).covariance);
  stamp_s_ += 1.0;
  EXPECT_FALSE(track({}).covariance);
  const auto after = track({}, motionBetween(22, 23));
  EXPECT_FALSE(after.covariance);
  EXPECT_LT(distance_m(after.T_map_cam, truth(20)), 0.01) << "where it was last";
}

TEST_F(TrackingByMotionPriors, ANewSubmapBeginsWhereMotionsLead) {
  trackUntil(20);
  for (int image = 21; image <= 25; ++image) track({}, motionBetween(image - 1, image));
  SyntheticWorld elsewhere(3000, 99);
  const auto begun = track(elsewhere.look(SyntheticWorld::T_world_cam(26, kImages)), motionBetween(25, 26));
  ASSERT_EQ(begun.state, State::Ok);
  EXPECT_EQ(begun.piece, 1U) << "not that of the first";
  EXPECT_LT(distance_m(begun.T_map_cam, truth(26)), 0.04);
}

TEST_F(TrackingByMotionPriors, ANewSubmapBeginsWhereItIsPlaced) {
  trackUntil(20);
  for (int image = 21; image <= 25; ++image) track({});
  const auto placed = truth(70);
  SyntheticWorld elsewhere(3000, 99);
  int asked = 0;
  const auto placeAnew = [&](const Eigen::Isometry3d& T_map_cam) {
    ++asked;
    EXPECT_LT(distance_m(T_map_cam, truth(20)), 0.01) << "where it was last";
    return placed;
  };
  const auto begun = track(elsewhere.look(SyntheticWorld::T_world_cam(26, kImages)), {}, placeAnew);
  ASSERT_EQ(begun.state, State::Ok);
  EXPECT_LT(distance_m(begun.T_map_cam, placed), 1e-9);
  EXPECT_LT(distance_m(begun.keyframe->T_map_cam, placed), 1e-9);
  EXPECT_EQ(track(elsewhere.look(SyntheticWorld::T_world_cam(27, kImages)), {}, placeAnew).state, State::Ok);
  EXPECT_EQ(asked, 1) << "only who begins anew";
}

}  // namespace
}  // namespace wardslam::odometry
