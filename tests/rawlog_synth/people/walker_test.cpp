#include "people/walker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace wardslam::synth {
namespace {

/// East for 4 m, a rest of 2 s, back.
Walker thereAndBack() {
  return Walker({{0.0, {0, 0}}, {4.0, {4, 0}}, {6.0, {4, 0}}, {10.0, {0, 0}}, {12.0, {0, 0}}}, 0.0);
}

TEST(Walker, PassesItsWaypointsInTime) {
  const Walker walker = thereAndBack();
  EXPECT_NEAR((walker.at(0.0).p_m - Eigen::Vector2d(0, 0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((walker.at(4.0).p_m - Eigen::Vector2d(4, 0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((walker.at(10.0).p_m - Eigen::Vector2d(0, 0)).norm(), 0.0, 1e-9);
}

TEST(Walker, NeverOvershoots) {
  const Walker walker = thereAndBack();
  for (double t = 0; t < 12; t += 0.013) {
    EXPECT_GE(walker.at(t).p_m.x(), -1e-9);
    EXPECT_LE(walker.at(t).p_m.x(), 4 + 1e-9);
  }
}

TEST(Walker, StandsStillBetweenWaypointsAtOnePlace) {
  const Walker walker = thereAndBack();
  EXPECT_TRUE(walker.at(2.0).moving);
  EXPECT_FALSE(walker.at(5.0).moving);
  EXPECT_EQ(walker.at(5.0).speed_mps, 0.0);
  EXPECT_EQ(walker.at(5.0).heading_rad, walker.at(5.5).heading_rad);
  EXPECT_TRUE(walker.at(8.0).moving);
}

TEST(Walker, FacesWhereItGoes) {
  const Walker walker = thereAndBack();
  EXPECT_NEAR(std::cos(walker.at(2.0).heading_rad), 1.0, 1e-6);
  EXPECT_NEAR(std::cos(walker.at(9.0).heading_rad), -1.0, 0.01);
}

TEST(Walker, CountsTheWayItWalked) {
  const Walker walker = thereAndBack();
  EXPECT_NEAR(walker.at(5.0).walked_m, 4.0, 0.02);
  EXPECT_NEAR(walker.at(12.0).walked_m, 8.0, 0.04);
}

TEST(Walker, RepeatsItsLoop) {
  const Walker walker({{0.0, {-3, 1}}, {2.0, {0, 0}}, {5.0, {2, 2}}, {8.0, {0, 0}}}, 2.0);
  for (double t = 2.0; t < 8.0; t += 0.37) {
    EXPECT_NEAR((walker.at(t).p_m - walker.at(t + 6.0).p_m).norm(), 0.0, 0.02) << t;
    EXPECT_NEAR((walker.at(t + 6.0).p_m - walker.at(t + 24.0).p_m).norm(), 0.0, 1e-6) << t;
  }
}

TEST(Walker, RefusesRoutesItCannotWalk) {
  EXPECT_THROW(Walker({{0.0, {0, 0}}}, 0.0), std::invalid_argument);
  EXPECT_THROW(Walker({{0.0, {0, 0}}, {0.0, {1, 0}}}, 0.0), std::invalid_argument);
  EXPECT_THROW(Walker({{0.0, {0, 0}}, {1.0, {1, 0}}}, 0.0), std::invalid_argument) << "the loop does not close";
  EXPECT_THROW(Walker({{0.0, {0, 0}}, {1.0, {0, 0}}}, 1.0), std::invalid_argument) << "the loop is empty";
}

}  // namespace
}  // namespace wardslam::synth
