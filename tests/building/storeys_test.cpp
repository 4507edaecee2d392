#include "wardslam/building/storeys.h"

#include <gmock/gmock.h>

namespace wardslam::building {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A camera that looks along x, level, 1.2 m over the floor if it sees it.
void addKeyframe(mapping::SemanticMap& map, std::uint64_t id, double x_m, double floor_m, bool seesFloor = true) {
  mapping::MappedKeyframe& keyframe = map.keyframes[id];
  keyframe.piece = map.piece;
  keyframe.T_map_cam.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  keyframe.T_map_cam.translation() = Eigen::Vector3d(x_m, 0.0, floor_m + 1.2);
  if (seesFloor) keyframe.ground = core::GroundPlane{-Eigen::Vector3d::UnitY(), 1.2, Eigen::Matrix3d::Zero()};
}

TEST(StoreysTest, AreToldApartByTheHeightOfTheirFloors) {
  mapping::SemanticMap map;
  addKeyframe(map, 1, 0, 3.6);
  addKeyframe(map, 2, 0, 0.0);
  addKeyframe(map, 3, 5, 0.3);  // up a ramp
  addKeyframe(map, 4, 9, 0.9);
  const auto storeys = storeysOf(map);
  ASSERT_EQ(storeys.size(), 2U);
  EXPECT_THAT(storeys[0].keyframes, ElementsAre(2, 3, 4));
  EXPECT_NEAR(storeys[0].lowest_m, 0.0, 1e-9);
  EXPECT_NEAR(storeys[0].highest_m, 0.9, 1e-9);
  EXPECT_TRUE(storeys[0].hasPlan);
  EXPECT_THAT(storeys[1].keyframes, ElementsAre(1));
  EXPECT_NEAR(storeys[1].lowest_m, 3.6, 1e-9);
  EXPECT_FALSE(storeys[1].hasPlan);
}

TEST(StoreysTest, WhoSeesNoFloorStandsOnThatOfTheNearest) {
  mapping::SemanticMap map;
  addKeyframe(map, 1, 0, 0.0);
  addKeyframe(map, 2, 0, 3.6);
  addKeyframe(map, 3, 1, 3.9, false);  // a head higher
  const auto storeys = storeysOf(map);
  ASSERT_EQ(storeys.size(), 2U);
  EXPECT_THAT(storeys[1].keyframes, ElementsAre(2, 3));
  EXPECT_TRUE(storeys[1].hasPlan);
}

TEST(StoreysTest, OfAsManyKeyframesTheLowestHasThePlan) {
  mapping::SemanticMap map;
  addKeyframe(map, 1, 0, 3.6);
  addKeyframe(map, 2, 0, 0.0);
  EXPECT_TRUE(storeysOf(map)[0].hasPlan);
}

TEST(StoreysTest, AreOfTheMapAlone) {
  mapping::SemanticMap map;
  addKeyframe(map, 1, 0, 0.0);
  addKeyframe(map, 2, 0, 3.6);
  map.keyframes[2].piece = 7;
  EXPECT_EQ(storeysOf(map).size(), 1U);
  map.keyframes[1].ground.reset();
  EXPECT_THAT(storeysOf(map), IsEmpty()) << "nobody saw the floor";
}

TEST(StoreysTest, AThingIsOnTheHighestFloorBeneathIt) {
  const std::vector<Storey> storeys = {{0.0, 0.9, {1, 2}, true}, {3.6, 3.6, {3}, false}};
  EXPECT_EQ(&storeyAt(storeys, 0.4), &storeys[0]);
  EXPECT_EQ(&storeyAt(storeys, 3.0), &storeys[0]) << "a lamp at the ceiling";
  EXPECT_EQ(&storeyAt(storeys, 3.2), &storeys[1]);
  EXPECT_EQ(&storeyAt(storeys, 5.0), &storeys[1]);
  EXPECT_EQ(&storeyAt(storeys, -2.0), &storeys[0]);
  EXPECT_TRUE(isOnPlan(storeys, 0.4));
  EXPECT_FALSE(isOnPlan(storeys, 4.0));
  EXPECT_TRUE(isOnPlan({}, 4.0)) << "nobody knows of storeys";
}

}  // namespace
}  // namespace wardslam::building
