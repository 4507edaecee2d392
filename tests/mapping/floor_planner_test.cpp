#include "wardslam/mapping/floor_planner.h"

#include <gmock/gmock.h>

#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::mapping {
namespace {

constexpr double kEye_m = 1.0;
constexpr double kWall_m = 3.0;

core::CameraModel camera() { return {}; }

/// Level, looking along x.
Eigen::Isometry3d T_map_cam(double x_m, double y_m) {
  return Eigen::Translation3d(x_m, y_m, kEye_m) * core::T_sensor_cam();
}

/// Floor, a wall across the x axis, and a box of 0.4 m height at x = 2 m between y = 0.5 and 1 m.
cv::Mat lookAtWall() {
  cv::Mat depth_m(480, 640, CV_32FC1);
  depth_m.forEach<float>([](float& value, const int* at) {
    const Eigen::Vector3d ray = core::T_sensor_cam().linear() * camera().unproject({at[1], at[0]}, 1.0);
    double depth = kWall_m / ray.x();
    if (ray.z() < 0) depth = std::min(depth, -kEye_m / ray.z());
    const Eigen::Vector3d atBox = 2.0 / ray.x() * ray;
    if (atBox.y() > 0.5 && atBox.y() < 1.0 && atBox.z() + kEye_m > 0 && atBox.z() + kEye_m < 0.4) {
      depth = std::min(depth, 2.0 / ray.x());
    }
    value = static_cast<float>(depth);
  });
  return depth_m;
}

/// The end point of a fan in the direction of y / x, as x in the map.
double reach_m(const std::vector<Eigen::Vector3f>& fan_cam_m, double slope) {
  double nearest = 1e9;
  double x_m = -1;
  for (const auto& end_cam_m : fan_cam_m) {
    const Eigen::Vector3d end = T_map_cam(0, 0) * end_cam_m.cast<double>();
    const double miss = std::abs(end.y() / end.x() - slope);
    if (miss < nearest) {
      nearest = miss;
      x_m = end.x();
    }
  }
  return x_m;
}

unsigned char cellAt(const FloorPlan& plan, double x_m, double y_m) {
  const Eigen::Vector2d cell = ((Eigen::Vector2d(x_m, y_m) - plan.origin_m) / plan.resolution_m).array().floor();
  return plan.cells.at<unsigned char>(static_cast<int>(cell.y()), static_cast<int>(cell.x()));
}

TEST(FreeFan, ReachesToWhatIsInTheWay) {
  const auto fan = freeFan(lookAtWall(), camera(), T_map_cam(0, 0), {});
  EXPECT_NEAR(reach_m(fan, 0.0), kWall_m, 0.01);
  EXPECT_NEAR(reach_m(fan, 0.375), 2.0, 0.01) << "the box";
  EXPECT_NEAR(reach_m(fan, -0.375), kWall_m, 0.01);
}

TEST(FreeFan, EndsWhereTheOptionSays) {
  FloorPlanOptions options;
  options.max_range_m = 1.5;
  EXPECT_NEAR(reach_m(freeFan(lookAtWall(), camera(), T_map_cam(0, 0), options), 0.0), 1.5, 0.01);
}

TEST(FreeFan, PassesUnderWhatIsHighAndOverWhatIsLow) {
  FloorPlanOptions lowRobot;
  lowRobot.min_height_m = 0.5;
  lowRobot.max_height_m = 0.9;
  const auto fan = freeFan(lookAtWall(), camera(), T_map_cam(0, 0), lowRobot);
  EXPECT_NEAR(reach_m(fan, 0.375), kWall_m, 0.01) << "over the box";
}

TEST(FreeFan, SaysNothingWhereNothingWasMeasured) {
  cv::Mat depth_m = lookAtWall();
  depth_m.colRange(300, 340) = 0.0;
  const auto fan = freeFan(depth_m, camera(), T_map_cam(0, 0), {});
  EXPECT_GT(std::abs(reach_m(fan, 0.0)), 0.0);
  for (const auto& end : fan) EXPECT_GT(std::abs(end.x() / end.z()), 0.02F);
  EXPECT_TRUE(freeFan(cv::Mat::zeros(480, 640, CV_32FC1), camera(), T_map_cam(0, 0), {}).empty());
}

class FloorPlanTest : public ::testing::Test {
 protected:
  FloorPlanTest() {
    map_.keyframes[1].T_map_cam = T_map_cam(0, 0);
    map_.keyframes[1].freeFan_cam_m = freeFan(lookAtWall(), camera(), T_map_cam(0, 0), {});
  }
  void addColumn(double x_m, double y_m, double fromHeight_m, double toHeight_m) {
    for (double z_m = fromHeight_m; z_m < toHeight_m; z_m += 0.02) {
      SemanticPoint point;
      point.p_cam_m = (T_map_cam(0, 0).inverse() * Eigen::Vector3d(x_m, y_m, z_m)).cast<float>();
      map_.cloud[1].points.push_back(point);
    }
  }

  SemanticMap map_;
};

TEST_F(FloorPlanTest, IsFreeWhereSeenFreeAndUnknownElsewhere) {
  const auto plan = drawFloorPlan(map_, {});
  EXPECT_EQ(plan.resolution_m, 0.05);
  EXPECT_EQ(cellAt(plan, 1.5, 0.0), FloorPlan::kFree);
  EXPECT_EQ(cellAt(plan, 2.8, -0.9), FloorPlan::kFree);
  EXPECT_EQ(cellAt(plan, 2.8, 1.05), FloorPlan::kUnknown) << "behind the box";
  EXPECT_EQ(cellAt(plan, 3.2, 0.0), FloorPlan::kUnknown) << "behind the wall";
  EXPECT_EQ(cellAt(plan, 0.5, 1.0), FloorPlan::kUnknown) << "beside the image";
}

TEST_F(FloorPlanTest, IsOccupiedWhereTheCloudIsInARobotsWay) {
  addColumn(1.525, 0.025, 0.0, 2.0);
  addColumn(1.525, 0.325, 0.0, 0.09);
  addColumn(1.525, -0.325, 1.9, 2.3);
  const auto plan = drawFloorPlan(map_, {});
  EXPECT_EQ(cellAt(plan, 1.525, 0.025), FloorPlan::kOccupied);
  EXPECT_EQ(cellAt(plan, 1.525, 0.325), FloorPlan::kFree) << "low enough to drive over";
  EXPECT_EQ(cellAt(plan, 1.525, -0.325), FloorPlan::kFree) << "high enough to drive under";
}

TEST_F(FloorPlanTest, FollowsKeyframesThatMove) {
  addColumn(1.525, 0.025, 0.0, 2.0);
  map_.keyframes[1].T_map_cam = T_map_cam(10, 5);
  const auto plan = drawFloorPlan(map_, {});
  EXPECT_EQ(cellAt(plan, 11.525, 5.025), FloorPlan::kOccupied);
  EXPECT_EQ(cellAt(plan, 11.0, 5.0), FloorPlan::kFree);
}

TEST_F(FloorPlanTest, CellsOfTwoPlansLieOnOneRaster) {
  const auto plan = drawFloorPlan(map_, {});
  for (const double corner_m : {plan.origin_m.x(), plan.origin_m.y()}) {
    EXPECT_NEAR(std::remainder(corner_m, plan.resolution_m), 0.0, 1e-9);
  }
}

TEST_F(FloorPlanTest, OfNothingIsEmptyAndOfTheWorldIsRefused) {
  EXPECT_TRUE(drawFloorPlan({}, {}).cells.empty());
  map_.keyframes[2].T_map_cam = T_map_cam(1e5, 1e5);
  EXPECT_THAT([&] { static_cast<void>(drawFloorPlan(map_, {})); },
              ::testing::ThrowsMessage<core::InputError>(::testing::HasSubstr("floor_plan.resolution_m")));
}

}  // namespace
}  // namespace wardslam::mapping
