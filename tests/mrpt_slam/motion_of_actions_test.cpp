#include "motion_of_actions.h"

#include <gmock/gmock.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/poses/CPosePDFGaussian.h>

#include <limits>

#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::mrpt_slam {
namespace {

using mrpt::obs::CActionCollection;
using mrpt::obs::CActionRobotMovement2D;
using mrpt::obs::CActionRobotMovement3D;
using testing::HasSubstr;
using testing::ThrowsMessage;

CActionCollection planarAction(double ahead_m, double turn_rad, double variance) {
  mrpt::poses::CPosePDFGaussian pdf(mrpt::poses::CPose2D(ahead_m, 0.0, turn_rad));
  pdf.cov.setZero();
  pdf.cov(0, 0) = pdf.cov(1, 1) = variance;
  pdf.cov(2, 2) = 2.0 * variance;
  CActionRobotMovement2D movement;
  movement.estimationMethod = CActionRobotMovement2D::emOdometry;
  movement.poseChange = mrpt::poses::CPosePDF::Ptr(std::make_shared<mrpt::poses::CPosePDFGaussian>(pdf));
  CActionCollection actions;
  actions.insert(movement);
  return actions;
}

TEST(MotionOfActions, TakesAMotionOverTheFloorWithItsCovariance) {
  const auto motion = motionOf(planarAction(0.2, M_PI / 2.0, 0.0004));
  ASSERT_TRUE(motion);
  EXPECT_TRUE(motion->T_previous_now.translation().isApprox(Eigen::Vector3d(0.2, 0.0, 0.0), 1e-9));
  EXPECT_TRUE((motion->T_previous_now.linear() * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitY(), 1e-9));
  const auto& covariance = motion->covariance;
  EXPECT_NEAR(covariance(0, 0), 0.0004, 1e-7);
  EXPECT_NEAR(covariance(1, 1), 0.0004, 1e-7);
  EXPECT_NEAR(covariance(5, 5), 0.0008, 1e-7) << "about z";
  EXPECT_NEAR(covariance(2, 2), 0.005 * 0.005, 1e-7) << "the floor may lift";
  EXPECT_NEAR(covariance(3, 3), 0.01 * 0.01, 1e-7) << "and tilt";
}

TEST(MotionOfActions, PrefersAMotionInThreeDimensions) {
  auto actions = planarAction(0.2, 0.0, 0.0004);
  CActionRobotMovement3D spatial;
  spatial.poseChange.mean = mrpt::poses::CPose3D(0.0, 0.0, 0.3, 0.0, 0.0, 0.0);
  spatial.poseChange.cov.setDiagonal(6, 0.01);
  actions.insert(spatial);
  const auto motion = motionOf(actions);
  ASSERT_TRUE(motion);
  EXPECT_NEAR(motion->T_previous_now.translation().z(), 0.3, 1e-12);
  EXPECT_NEAR(motion->covariance(2, 2), 0.01, 1e-6);
}

TEST(MotionOfActions, OfNoneKnowsNothing) { EXPECT_FALSE(motionOf(CActionCollection())); }

TEST(MotionOfActions, AMotionWithoutCovarianceIsSureToAFractionOfAMillimetre) {
  const auto motion = motionOf(planarAction(0.2, 0.0, 0.0));
  ASSERT_TRUE(motion);
  EXPECT_NEAR(motion->covariance(0, 0), 1e-8, 1e-12);
}

TEST(MotionOfActions, RefusesWhatIsNoMotion) {
  const auto expectRefused = [](double ahead_m, double variance) {
    EXPECT_THAT([&] { static_cast<void>(motionOf(planarAction(ahead_m, 0.0, variance))); },
                ThrowsMessage<core::InputError>(HasSubstr("odometry of an action is no motion")));
  };
  expectRefused(std::numeric_limits<double>::quiet_NaN(), 0.01);
  expectRefused(std::numeric_limits<double>::infinity(), 0.01);
  expectRefused(0.1, -0.01);
}

mrpt::obs::CObservationOdometry reading(double stamp_s, double x_m) {
  mrpt::obs::CObservationOdometry odometer;
  odometer.timestamp = core::toMrptTime(stamp_s);
  odometer.odometry = mrpt::poses::CPose2D(x_m, 0.0, 0.0);
  return odometer;
}

/// 0.5 m in half a second: 0.1 m in a tenth of a second.
TEST(OdometerMotion, BetweenTwoImagesTheRobotIsAsFastAsBetweenTwoReadings) {
  OdometerMotion odometer;
  EXPECT_FALSE(odometer.between(100.0, 100.1));
  odometer.add(reading(100.0, 2.0));
  EXPECT_FALSE(odometer.between(100.0, 100.1)) << "one reading is no motion";
  odometer.add(reading(100.5, 2.5));
  const auto motion = odometer.between(100.5, 100.6);
  ASSERT_TRUE(motion);
  EXPECT_NEAR(motion->T_previous_now.translation().x(), 0.1, 1e-6);
  EXPECT_FALSE(odometer.between(101.0, 101.1)) << "that was long ago";
  odometer.add(reading(100.2, 9.0));
  EXPECT_NEAR(odometer.between(100.5, 100.6)->T_previous_now.translation().x(), 0.1, 1e-6) << "came too late";
}

}  // namespace
}  // namespace wardslam::mrpt_slam
