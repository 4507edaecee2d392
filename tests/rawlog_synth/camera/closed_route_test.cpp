#include "camera/closed_route.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace wardslam::synth {
namespace {

ClosedRoute square() { return {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, 1.0}; }

TEST(ClosedRoute, IsAsLongAsItsSidesAndBends) { EXPECT_NEAR(square().length_m(), 4 * 2.0 + 2 * M_PI, 1e-9); }

TEST(ClosedRoute, BeginsInTheMiddleOfTheLastSideAndEndsThere) {
  const ClosedRoute route = square();
  EXPECT_TRUE(route.at(0.0).p_m.isApprox(Eigen::Vector2d(0, 2), 1e-9));
  EXPECT_TRUE(route.at(route.length_m()).p_m.isApprox(Eigen::Vector2d(0, 2), 1e-9));
  EXPECT_NEAR(route.at(0.0).heading_rad, -M_PI / 2, 1e-9);
  EXPECT_NEAR(route.at(route.length_m()).heading_rad, 1.5 * M_PI, 1e-9) << "a whole turn to the left";
}

TEST(ClosedRoute, RoundsCorners) {
  const Eigen::Vector2d inBend_m = square().at(1.0 + M_PI / 4).p_m;
  EXPECT_TRUE(inBend_m.isApprox(Eigen::Vector2d(1 - std::sqrt(0.5), 1 - std::sqrt(0.5)), 1e-3)) << inBend_m;
}

TEST(ClosedRoute, TurnsGently) {
  const ClosedRoute route = square();
  for (double s_m = -3.0; s_m < 2 * route.length_m(); s_m += 0.037) {
    const double turn = route.at(s_m + 0.01).heading_rad - route.at(s_m).heading_rad;
    EXPECT_GE(turn, -1e-9);
    EXPECT_LT(turn / 0.01, M_PI / 2 / 1.5) << "a bend of its own would turn by 1 rad a metre";
    EXPECT_NEAR((route.at(s_m + 0.01).p_m - route.at(s_m).p_m).norm(), 0.01, 1e-4);
  }
}

TEST(ClosedRoute, RefusesSidesTooShortForTheirBends) {
  EXPECT_THROW(ClosedRoute({{0, 0}, {1, 0}, {1, 4}, {0, 4}}, 0.9), std::invalid_argument);
  EXPECT_THROW(ClosedRoute({{0, 0}, {1, 0}}, 0.1), std::invalid_argument);
}

}  // namespace
}  // namespace wardslam::synth
