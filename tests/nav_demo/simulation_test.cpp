#include "simulation.h"

#include <gtest/gtest.h>

#include "run_picture.h"
#include "support/hand_made_map.h"
#include "support/temporary_folder.h"

namespace wardslam::nav_demo {
namespace {

/// From one room of the hand-made ward through the gap in the wall to the bed in the other.
class SimulationTest : public testing::Test {
 protected:
  SimulationTest() {
    map_.floorPlan.cells(cv::Rect(120, 60, 20, 40)).setTo(mapping::FloorPlan::kOccupied);  // the bed
    map_.floorPlan.cells(cv::Rect(0, 0, 160, 1)).setTo(mapping::FloorPlan::kOccupied);
    order_.target = "bed 1";
    order_.start_map = Eigen::Vector3d(2.0, 3.2, M_PI);  // looks away from the way
    options_.peopleCount = 1;
  }

  RunRecord run(std::uint32_t seed) {
    mission_ = planMission(map_, order_, options_.robot);
    return simulate(mission_, truthFromMap(map_), options_, seed, folder_.path());
  }

  test::TemporaryFolder folder_;
  mapping::SemanticMap map_ = test::makeWard();
  Order order_;
  Mission mission_;
  SimulationOptions options_;
};

TEST_F(SimulationTest, DeliversAndSaysHowItWent) {
  const auto record = run(1);
  EXPECT_TRUE(record.isGood());
  EXPECT_LT(record.goalError_m, 0.15);
  EXPECT_LT(record.facingError_rad, 0.1);
  EXPECT_GT(record.toTarget_m, 0.0);
  EXPECT_LT(record.toTarget_m, kReach_m + 0.1);
  EXPECT_GT(record.verdict.way_m, 2.5);
  EXPECT_NEAR(record.time_s, static_cast<double>(record.moments.size()) / 10.0, 0.2);
  const cv::Mat picture = drawRun(map_, mission_, options_, record);
  EXPECT_GT(picture.rows, 100);
}

TEST_F(SimulationTest, TheSameSeedGivesTheSameRun) {
  const auto first = run(5);
  const auto second = run(5);
  ASSERT_EQ(first.moments.size(), second.moments.size());
  for (std::size_t i = 0; i < first.moments.size(); ++i) {
    ASSERT_EQ(first.moments[i].T_map_robot.matrix(), second.moments[i].T_map_robot.matrix());
    ASSERT_EQ(first.moments[i].people_m, second.moments[i].people_m);
  }
}

TEST_F(SimulationTest, GivesUpWhenTimeIsOver) {
  options_.timeLimit_s = 2.0;
  const auto record = run(1);
  EXPECT_FALSE(record.arrived);
  EXPECT_FALSE(record.isGood());
  EXPECT_LE(record.time_s, 2.0);
}

}  // namespace
}  // namespace wardslam::nav_demo
