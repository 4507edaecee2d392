#include "mission.h"

#include <gmock/gmock.h>

#include "support/complaint.h"
#include "support/hand_made_map.h"
#include "wardslam/core/errors.h"
#include "wardslam/query/object_name.h"

namespace wardslam::nav_demo {
namespace {

using testing::HasSubstr;

/// The hand-made ward: bed 1 stands at (5.5, 3), behind a wall along x = 3 that is open for y > 4.
class MissionTest : public testing::Test {
 protected:
  MissionTest() {
    map_.floorPlan.cells(cv::Rect(120, 60, 20, 40)).setTo(mapping::FloorPlan::kOccupied);  // the bed
    order_.target = "bed 1";
    order_.start_map = Eigen::Vector3d(0.0, 1.0, 0.0);
  }

  std::string complaint() const {
    return test::complaintOf([&] { return planMission(map_, order_, {}); });
  }
  void forbid(const std::vector<Eigen::Vector2d>& polygon_m) {
    map_.zones.push_back({"store", polygon_m});
    order_.forbidden = {"store"};
  }

  mapping::SemanticMap map_ = test::makeWard();
  Order order_;
};

TEST_F(MissionTest, EndsBesideTheBed) {
  const auto mission = planMission(map_, order_, {});
  EXPECT_EQ(mission.name, "bed 1");
  const Eigen::AlignedBox2d bed(Eigen::Vector2d(5.0, 2.0), Eigen::Vector2d(6.0, 4.0));
  EXPECT_GE(bed.exteriorDistance(mission.spot.p_map_m), 0.25);
  EXPECT_LE(bed.exteriorDistance(mission.spot.p_map_m), 0.6 + 0.32);
  EXPECT_LT((mission.route_m.back() - mission.spot.p_map_m).norm(), 0.05);
  const Eigen::Vector2d looks(std::cos(mission.spot.yaw_rad), std::sin(mission.spot.yaw_rad));
  EXPECT_LT(bed.exteriorDistance(mission.spot.p_map_m + 0.7 * looks), 0.3);
}

TEST_F(MissionTest, StartsWhereTheMapEndsUnlessTold) {
  order_.start_map.reset();
  const auto mission = planMission(map_, order_, {});
  EXPECT_LT((mission.T_map_start.translation() - Eigen::Vector2d(1.5, 1.0)).norm(), 1e-9);
}

TEST_F(MissionTest, SaysWhyNothingCanBeDelivered) {
  order_.target = "bed 7";
  EXPECT_THAT(complaint(), HasSubstr("only bed 1"));
  order_.target = "bed 1";
  order_.forbidden = {"shop"};
  EXPECT_THAT(complaint(), HasSubstr("no zone is called 'shop'"));
  order_.forbidden.clear();
  order_.start_map = Eigen::Vector3d(3.1, 0.0, 0.0);
  EXPECT_THAT(complaint(), HasSubstr("does not start on free floor"));
}

TEST_F(MissionTest, SaysThatAZoneIsInTheWay) {
  forbid({{4.0, 1.0}, {7.0, 1.0}, {7.0, 5.0}, {4.0, 5.0}});
  EXPECT_THAT(complaint(), HasSubstr("zone 'store' leaves no spot beside bed 1"));
  map_.zones.back().polygon_m = {{2.5, 3.5}, {3.5, 3.5}, {3.5, 5.0}, {2.5, 5.0}};
  EXPECT_THAT(complaint(), HasSubstr("zone 'store' cuts off all ways to bed 1"));
  map_.zones.back().polygon_m = {{-0.5, 0.5}, {0.5, 0.5}, {0.5, 1.5}, {-0.5, 1.5}};
  EXPECT_THAT(complaint(), HasSubstr("starts within forbidden zone 'store'"));
}

TEST_F(MissionTest, ZonesThatForbidThemselvesNeedNotBeNamed) {
  forbid({{2.5, 3.5}, {3.5, 3.5}, {3.5, 5.0}, {2.5, 5.0}});
  order_.forbidden.clear();
  EXPECT_NO_THROW(static_cast<void>(planMission(map_, order_, {}))) << "a place forbids nothing";
  map_.zones.back().type = mapping::ZoneType::Forbidden;
  EXPECT_THAT(complaint(), HasSubstr("zone 'store' cuts off all ways to bed 1"));
  order_.forbidden = {"store"};
  EXPECT_THAT(complaint(), HasSubstr("zone 'store' cuts off all ways")) << "and is told once where it is";
}

TEST_F(MissionTest, SaysThatThereIsNoSpotOrNoWay) {
  map_.floorPlan.cells(cv::Rect(100, 40, 60, 80)).setTo(mapping::FloorPlan::kOccupied);
  EXPECT_THAT(complaint(), HasSubstr("no free spot beside bed 1"));
  map_ = test::makeWard();
  map_.floorPlan.cells.colRange(80, 84).setTo(mapping::FloorPlan::kOccupied);
  EXPECT_THAT(complaint(), HasSubstr("no way leads from the robot to a spot beside bed 1"));
  map_.floorPlan.cells.release();
  EXPECT_THAT(complaint(), HasSubstr("no floor plan"));
}

}  // namespace
}  // namespace wardslam::nav_demo
