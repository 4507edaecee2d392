#include "scene/floor_truth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wardslam::synth {
namespace {

using mapping::FloorPlan;

unsigned char cellAt(const FloorPlan& plan, double x_m, double y_m) {
  const Eigen::Vector2d cell = (Eigen::Vector2d(x_m, y_m) - plan.origin_m) / plan.resolution_m;
  return plan.cells.at<unsigned char>(static_cast<int>(cell.y()), static_cast<int>(cell.x()));
}

Thing boxAt(float x_m, float y_m, float z_m, const Eigen::Vector3f& size_m) {
  return {{1, "box", 1, "box"}, {{Material::Plastic, box(size_m).transform(at(x_m, y_m, z_m))}}};
}

TEST(FloorTruth, IsOccupiedWhereSurfacesAreInTheWayOfARobot) {
  Scene scene;
  scene.things.push_back(boxAt(1.0F, 2.0F, 0.5F, {0.4F, 0.2F, 1.0F}));
  const FloorPlan plan = trueFloor(scene, 0.0);
  EXPECT_EQ(cellAt(plan, 0.81, 2.0), FloorPlan::kOccupied);
  EXPECT_EQ(cellAt(plan, 1.0, 2.09), FloorPlan::kOccupied);
  EXPECT_EQ(cellAt(plan, 0.77, 2.0), FloorPlan::kFree);
  EXPECT_EQ(cellAt(plan, 1.0, 2.13), FloorPlan::kFree);
}

TEST(FloorTruth, LeavesOutWhatARobotDrivesOverOrUnder) {
  Scene scene;
  scene.things.push_back(boxAt(0.0F, 0.0F, 0.5F, {0.1F, 0.1F, 1.0F}));
  scene.things.push_back(boxAt(2.0F, 0.0F, 0.02F, {1.0F, 1.0F, 0.04F}));  // a mat
  scene.things.push_back(boxAt(2.0F, 3.0F, 2.0F, {1.0F, 1.0F, 0.2F}));    // a lamp
  const FloorPlan plan = trueFloor(scene, 0.0);
  EXPECT_LT(plan.origin_m.x() + plan.resolution_m * plan.cells.cols, 1.0);  // nothing there
}

TEST(FloorTruth, IsThatOfTheStoreyAskedFor) {
  Scene scene;
  scene.things.push_back(boxAt(0.0F, 0.0F, 0.5F, {0.1F, 0.1F, 1.0F}));
  scene.things.push_back(boxAt(2.0F, 0.0F, 4.1F, {0.1F, 0.1F, 1.0F}));
  const FloorPlan above = trueFloorAt(scene, 0.0, 3.6F);
  EXPECT_NEAR(above.origin_m.x(), 1.95 - 0.2, 0.01);
  EXPECT_EQ(cellAt(above, 2.04, 0.0), FloorPlan::kOccupied);
  EXPECT_NEAR(trueFloor(scene, 0.0).origin_m.x(), -0.05 - 0.2, 0.01);
}

TEST(FloorTruth, ALongWallHasNoHoles) {
  constexpr float kTurn_rad = 0.3F;
  const Mesh wall = panel({0, 0, 0}, {40, 0, 0}, {0, 0, 3}).transform(at(0, 0, 0, kTurn_rad));
  Scene scene;
  scene.things.push_back({{1, "wall", 1, "wall"}, {{Material::Plastic, wall}}});
  const FloorPlan plan = trueFloor(scene, 0.0);
  for (double along_m = 0.05; along_m < 39.95; along_m += 0.02) {
    EXPECT_EQ(cellAt(plan, along_m * std::cos(0.3), along_m * std::sin(0.3)), FloorPlan::kOccupied) << along_m;
  }
}

TEST(FloorTruth, OfNothingIsEmpty) { EXPECT_TRUE(trueFloor({}, 0.0).cells.empty()); }

}  // namespace
}  // namespace wardslam::synth
