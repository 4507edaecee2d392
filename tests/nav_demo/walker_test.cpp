#include "walker.h"

#include <gtest/gtest.h>

#include <optional>

namespace wardslam::nav_demo {
namespace {

constexpr double kStep_s = 0.02;

/// A corridor 6 m long and 1 m wide; somebody walks at x from -2.9 to 2.9.
class WalkerTest : public testing::Test {
 protected:
  WalkerTest() {
    mapping::FloorPlan plan;
    plan.resolution_m = 0.05;
    plan.origin_m = {-3.0, -0.5};
    plan.cells = cv::Mat(20, 120, CV_8UC1, cv::Scalar(mapping::FloorPlan::kFree));
    floor_.emplace(plan, query::DrivingRules{0.25, {}, false});
    ground_.floor = &*floor_;
  }

  std::optional<query::DrivableFloor> floor_;
  WalkingGround ground_;
  WalkerHabits habits_;
};

TEST_F(WalkerTest, GoesFromPlaceToPlaceNoFasterThanPeopleDo) {
  Walker walker(ground_, habits_, {0.0, 0.0}, 1);
  double way_m = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector2d before = walker.disc().p_m;
    walker.step(kStep_s, {});
    const double step_m = (walker.disc().p_m - before).norm();
    EXPECT_LE(step_m, habits_.fastest_mps * kStep_s + 1e-9);
    EXPECT_TRUE(floor_->nearestFree(walker.disc().p_m, 0.1));
    way_m += step_m;
  }
  EXPECT_GT(way_m, 5.0);
}

TEST_F(WalkerTest, StopsBeforeWhatStandsInTheWay) {
  habits_.patience_s = 1e9;
  ground_.attractions_m = {{2.5, 0.0}};  // goes there first
  Walker walker(ground_, habits_, {-2.0, 0.0}, 1);
  const Disc robot = {{1.0, 0.0}, 0.25};
  for (int i = 0; i < 1000; ++i) walker.step(kStep_s, {robot});
  const double gap_m = (walker.disc().p_m - robot.p_m).norm() - 0.5;
  EXPECT_GT(gap_m, 0.2);
  EXPECT_LT(gap_m, 0.6);
}

TEST_F(WalkerTest, PassesWhatIsBehind) {
  ground_.attractions_m = {{2.5, 0.0}};
  Walker walker(ground_, habits_, {0.0, 0.0}, 1);
  const Disc robot = {{-0.55, 0.0}, 0.25};
  for (int i = 0; i < 100; ++i) walker.step(kStep_s, {robot});
  EXPECT_GT(walker.disc().p_m.x(), 0.8);
}

TEST_F(WalkerTest, TheSameSeedWalksTheSameWay) {
  Walker first(ground_, habits_, {0.0, 0.0}, 7);
  Walker second(ground_, habits_, {0.0, 0.0}, 7);
  for (int i = 0; i < 500; ++i) {
    first.step(kStep_s, {});
    second.step(kStep_s, {});
  }
  EXPECT_EQ(first.disc().p_m, second.disc().p_m);
}

TEST_F(WalkerTest, PlacesAreFreeAndAway) {
  std::mt19937 random(3);
  for (int i = 0; i < 20; ++i) {
    const auto place = placeAwayFrom(ground_, {0.0, 0.0}, 1.0, random);
    EXPECT_GE(place.norm(), 1.0);
    EXPECT_TRUE(floor_->nearestFree(place, 0.0));
  }
}

}  // namespace
}  // namespace wardslam::nav_demo
