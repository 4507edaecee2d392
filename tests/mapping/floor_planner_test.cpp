#include "wardslam/mapping/floor_planner.h"

#include <gmock/gmock.h>

#include <opencv2/core.hpp>

#include "free_fan.h"
#include "mapping/scene.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/mapping/map_builder.h"

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

unsigned char cellAt(const FloorPlan& plan, double x_m, double y_m) {
  const Eigen::Vector2d cell = ((Eigen::Vector2d(x_m, y_m) - plan.origin_m) / plan.resolution_m).array().floor();
  return plan.cells.at<unsigned char>(static_cast<int>(cell.y()), static_cast<int>(cell.x()));
}

class FloorPlanTest : public ::testing::Test {
 protected:
  FloorPlanTest() {
    map_.keyframes[1].T_map_cam = T_map_cam(0, 0);
    map_.keyframes[1].freeFan_cam_m =
        freeFan(lookAtWall(), camera(), {core::GroundPlane::atZero(T_map_cam(0, 0)), false}, {});
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

TEST_F(FloorPlanTest, OfHardlyAnythingIsAPlanAndNoNaN) {
  SemanticMap bare;  // keyframes in one place that saw nothing
  for (std::uint64_t id = 1; id <= 3; ++id) bare.keyframes[id].T_map_cam = T_map_cam(1, 2);
  SemanticMap onePoint = bare;
  onePoint.cloud[1].points.emplace_back();
  onePoint.keyframes[1].freeFan_cam_m = {{0.0F, 1.0F, 2.0F}};
  SemanticMap upright = bare;  // a wall of one column of points, and a floor seen from it that stands upright
  for (int i = 0; i < 40; ++i) {
    SemanticPoint point;
    point.p_cam_m = {0.0F, 0.05F * static_cast<float>(i), 2.0F};
    upright.cloud[1].points.push_back(point);
  }
  upright.keyframes[1].ground = core::GroundPlane{};
  upright.keyframes[1].ground->normal_cam = Eigen::Vector3d::UnitX();
  for (const SemanticMap& map : {bare, onePoint, upright}) {
    const auto plan = drawFloorPlan(map, {});
    EXPECT_TRUE(plan.origin_m.allFinite());
    EXPECT_EQ(plan.resolution_m, 0.05);
    EXPECT_LT(plan.cells.total(), 1000U * 1000U);
  }
}

// The floor plan of a corridor that is driven along, however the map leans and the camera is held.

constexpr double kDeg = M_PI / 180.0;
constexpr double kDriven_m = 1.1;
constexpr double kStep_m = 1.0;

scene::Thing slab(const Eigen::Vector3d& min_m, const Eigen::Vector3d& max_m) { return {{min_m, max_m}, 0, 0, {}}; }

/// 24 m long, 2.4 m wide, with two boxes; not a metre of it is without a wall or a floor.
std::vector<scene::Thing> corridor() {
  return {slab({-1, -1.22, -0.1}, {24, 1.22, 0.0}), slab({-1, 1.22, -0.1}, {24, 1.3, 2.5}),
          slab({-1, -1.3, -0.1}, {24, -1.22, 2.5}), slab({24, -1.2, -0.1}, {24.1, 1.2, 2.5}),
          slab({6, 0.6, 0.0}, {6.6, 1.2, 0.5}),     slab({18, -1.2, 0.0}, {18.5, -0.5, 0.5})};
}

struct Areas {
  SemanticMap map;
  double free_m2 = 0.0;
  double floorToldOccupied_m2 = 0.0;
  std::size_t groundsSeen = 0;
  std::size_t keyframes = 0;
};

/// Of the floor that is truly free, and not beside a wall or a box.
double floorToldOccupied_m2(const FloorPlan& plan, const Eigen::Isometry3d& T_map_true) {
  const Eigen::AlignedBox2d floor(Eigen::Vector2d(1.0, -1.0), Eigen::Vector2d(23.5, 1.0));
  int wrong = 0;
  for (int row = 0; row < plan.cells.rows; ++row) {
    for (int column = 0; column < plan.cells.cols; ++column) {
      if (plan.cells.at<unsigned char>(row, column) != FloorPlan::kOccupied) continue;
      Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
      centre_m.head<2>() = plan.origin_m + plan.resolution_m * Eigen::Vector2d(column + 0.5, row + 0.5);
      const Eigen::Vector2d p_true_m = (T_map_true.inverse() * centre_m).head<2>();
      const bool isBox = (p_true_m.x() > 5.8 && p_true_m.x() < 6.8 && p_true_m.y() > 0.4) ||
                         (p_true_m.x() > 17.8 && p_true_m.x() < 18.7 && p_true_m.y() < -0.3);
      if (floor.contains(p_true_m) && !isBox) ++wrong;
    }
  }
  return wrong * plan.resolution_m * plan.resolution_m;
}

/// `T_map_true`: how the map lies to the truth, which is level. `R_held`: the camera in its mount.
Areas drive(const Eigen::Isometry3d& T_map_true, const Eigen::Matrix3d& R_held = Eigen::Matrix3d::Identity()) {
  MappingOptions options;
  options.cloud.min_sightings = 1;
  MapBuilder builder(options, MapSetting{});
  std::uint64_t id = 0;
  for (double x_m = 0.0; x_m <= 20.0; x_m += kStep_m) {
    odometry::Keyframe keyframe;
    keyframe.id = ++id;
    Eigen::Isometry3d T_true_cam = scene::cameraAt({x_m, 0, kDriven_m});
    T_true_cam.linear() = T_true_cam.linear() * R_held;
    keyframe.T_map_cam = T_map_true * T_true_cam;
    Eigen::Isometry3d T_true_previous = T_true_cam;
    T_true_previous.translation().x() -= kStep_m;
    keyframe.T_previous_cam = T_true_previous.inverse() * T_true_cam;
    builder.addKeyframe(keyframe);
    View view = scene::render(corridor(), T_true_cam, x_m, id, T_true_cam);
    view.isKeyframe = true;
    view.segmentation = {};
    builder.add(view);
  }
  const SemanticMap map = builder.map();
  const double cell_m2 = map.floorPlan.resolution_m * map.floorPlan.resolution_m;
  Areas areas;
  areas.free_m2 = cell_m2 * cv::countNonZero(map.floorPlan.cells == FloorPlan::kFree);
  areas.floorToldOccupied_m2 = floorToldOccupied_m2(map.floorPlan, T_map_true);
  areas.keyframes = map.keyframes.size();
  areas.map = map;
  for (const auto& [keyframe, content] : map.keyframes) areas.groundsSeen += content.ground ? 1U : 0U;
  return areas;
}

/// About the first camera.
Eigen::Isometry3d tilted(double angle_deg, const Eigen::Vector3d& axis) {
  const Eigen::Translation3d first(0, 0, kDriven_m);
  return first * Eigen::AngleAxisd(angle_deg * kDeg, axis) * first.inverse();
}

/// Turned about the optical axis (z), or up and down (x).
Eigen::Matrix3d held(double angle_deg, const Eigen::Vector3d& axis_cam) {
  return Eigen::AngleAxisd(angle_deg * kDeg, axis_cam).toRotationMatrix();
}

void expectSamePlan(const Areas& areas, const Areas& level) {
  EXPECT_NEAR(areas.free_m2, level.free_m2, 0.03 * level.free_m2);
  EXPECT_EQ(areas.floorToldOccupied_m2, 0.0);
  EXPECT_EQ(areas.groundsSeen, areas.keyframes);
}

class GroundOfMap : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { level_ = drive(Eigen::Isometry3d::Identity()); }
  static Areas level_;
};
Areas GroundOfMap::level_;

TEST_F(GroundOfMap, IsFreeUpToTheWalls) {
  EXPECT_GT(level_.free_m2, 35.0) << "of 2.4 m by 18 m and more";
  EXPECT_LT(level_.free_m2, 2.4 * 24);
  EXPECT_EQ(level_.groundsSeen, level_.keyframes);
}

TEST_F(GroundOfMap, HasTheSamePlanWhereTheStartWasTilted) {
  expectSamePlan(drive(tilted(1.0, Eigen::Vector3d::UnitY())), level_);
  expectSamePlan(drive(tilted(-1.0, Eigen::Vector3d::UnitY())), level_);
  expectSamePlan(drive(tilted(1.0, Eigen::Vector3d::UnitX())), level_);
  expectSamePlan(drive(tilted(5.0, Eigen::Vector3d::UnitY())), level_);
}

/// What a floor at z = 0 makes of it.
TEST_F(GroundOfMap, IsWhatKeepsThePlanSo) {
  const auto T_map_true = tilted(-1.0, Eigen::Vector3d::UnitY());
  SemanticMap map = drive(T_map_true).map;
  for (auto& [id, keyframe] : map.keyframes) keyframe.ground.reset();
  EXPECT_GT(floorToldOccupied_m2(drawFloorPlan(map, {}), T_map_true), 0.5);
}

TEST_F(GroundOfMap, HasTheSamePlanWhereTheStartWasTooHigh) {
  expectSamePlan(drive(Eigen::Isometry3d(Eigen::Translation3d(0, 0, 0.7))), level_);
}

/// The camera lies on its side. The image is narrower.
TEST_F(GroundOfMap, IsFoundByACameraOnItsSide) {
  const Eigen::Matrix3d onItsSide = held(90.0, Eigen::Vector3d::UnitZ());
  const Areas upright = drive(Eigen::Isometry3d::Identity(), onItsSide);
  const Areas leaning = drive(tilted(1.0, Eigen::Vector3d::UnitY()), onItsSide);
  EXPECT_GT(upright.free_m2, 0.65 * level_.free_m2) << "it sees less to the sides";
  expectSamePlan(leaning, upright);
}

TEST_F(GroundOfMap, IsFoundByACameraThatLooksDown) {
  const Areas down = drive(tilted(1.0, Eigen::Vector3d::UnitY()), held(-25.0, Eigen::Vector3d::UnitX()));
  EXPECT_GT(down.free_m2, 0.8 * level_.free_m2);
  EXPECT_EQ(down.groundsSeen, down.keyframes);
}

}  // namespace
}  // namespace wardslam::mapping
