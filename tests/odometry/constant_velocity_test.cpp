#include "constant_velocity.h"

#include <gtest/gtest.h>

#include "odometry/rendered_planes.h"

namespace wardslam::odometry {
namespace {

using test::moved;

TEST(ConstantVelocity, GoesOnPerSecondNotPerImage) {
  ConstantVelocity velocity;
  // 2 cm ahead and 0.02 rad to the right within 0.1 s.
  velocity.observe(moved({0, 0, 0.02}, {0, 0.02, 0}).inverse(), 0.1, true);
  const MotionPrior twice = velocity.predict(0.2);
  EXPECT_TRUE(twice.T_previous_now.isApprox(moved({0, 0, 0.04}, {0, 0.04, 0}), 1e-9));
  const MotionPrior half = velocity.predict(0.05);
  EXPECT_TRUE(half.T_previous_now.isApprox(moved({0, 0, 0.01}, {0, 0.01, 0}), 1e-9));
}

TEST(ConstantVelocity, NobodyGoesOnForLong) {
  ConstantVelocity velocity;
  velocity.observe(moved({0.1, 0, 0}, {0, 0, 0}).inverse(), 0.1, true);  // 1 m/s
  EXPECT_NEAR(velocity.predict(10.0).T_previous_now.translation().x(), 0.5, 1e-9);
}

TEST(ConstantVelocity, IsLessSureTheFartherAhead) {
  ConstantVelocity standing;
  const auto sigma_m = [&](double ahead_s) { return std::sqrt(standing.predict(ahead_s).covariance(0, 0)); };
  EXPECT_NEAR(sigma_m(0.1), 0.003 + 0.1, 1e-9) << "nobody knows how fast: up to a metre a second";
  standing.observe(Eigen::Isometry3d::Identity(), 0.1, true);
  EXPECT_NEAR(sigma_m(0.1), 0.003 + 0.5 * 0.01, 1e-4);
  EXPECT_NEAR(sigma_m(1.0), 0.003 + 0.5, 1e-4);
}

TEST(ConstantVelocity, GuessesOnGuessesGrowAsOneLongGuess) {
  ConstantVelocity velocity;
  velocity.observe(moved({0.01, 0, 0}, {0, 0, 0}).inverse(), 0.1, true);
  double sum_m2 = 0.0;
  for (int image = 0; image < 10; ++image) {
    sum_m2 += velocity.predict(0.1).covariance(0, 0);
    velocity.observe(moved({0.01, 0, 0}, {0, 0, 0}).inverse(), 0.1, false);
  }
  EXPECT_NEAR(std::sqrt(sum_m2), 0.003 + 0.5, 0.001) << "as after a second";
  velocity.observe(moved({0.01, 0, 0}, {0, 0, 0}).inverse(), 0.1, true);
  EXPECT_NEAR(std::sqrt(velocity.predict(0.1).covariance(0, 0)), 0.008, 1e-4) << "seen again";
}

TEST(ConstantVelocity, AClockThatStandsOrGoesBackTellsNothing) {
  ConstantVelocity velocity;
  for (const double since_s : {0.0, -0.1, std::nan("")}) {
    velocity.observe(moved({0.1, 0, 0}, {0, 0, 0}), since_s, true);
    EXPECT_TRUE(velocity.predict(0.1).T_previous_now.isApprox(Eigen::Isometry3d::Identity())) << since_s;
  }
  velocity.observe(moved({0.1, 0, 0}, {0, 0, 0}), 0.1, true);
  EXPECT_TRUE(velocity.predict(-1.0).T_previous_now.isApprox(Eigen::Isometry3d::Identity()));
  EXPECT_GT(velocity.predict(-1.0).covariance(0, 0), 0.0);
}

TEST(ConstantVelocity, ForgottenItStands) {
  ConstantVelocity velocity;
  velocity.observe(moved({0.1, 0, 0}, {0, 0, 0}), 0.1, true);
  velocity.forget();
  EXPECT_TRUE(velocity.predict(0.1).T_previous_now.isApprox(Eigen::Isometry3d::Identity()));
}

}  // namespace
}  // namespace wardslam::odometry
