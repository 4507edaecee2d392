#include "wardslam/mapping/zone.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wardslam::mapping {
namespace {

const Zone kTriangle = {"corner", {{0, 0}, {4, 0}, {0, 2}}};

TEST(Zone, HoldsWhatLiesWithinAndItsBorder) {
  EXPECT_TRUE(contains(kTriangle, {1, 1}));
  EXPECT_TRUE(contains(kTriangle, {2, 0}));
  EXPECT_FALSE(contains(kTriangle, {3, 1}));
  EXPECT_FALSE(contains({}, {0, 0}));
}

TEST(Zone, AreaIsThatOfThePolygonWhicheverWayAround) {
  EXPECT_DOUBLE_EQ(area_m2(kTriangle), 4.0);
  EXPECT_DOUBLE_EQ(area_m2({"corner", {{0, 2}, {4, 0}, {0, 0}}}), 4.0);
  EXPECT_DOUBLE_EQ(area_m2({}), 0.0);
}

TEST(Zone, DistanceIsThatToItsBorderAndNothingWithin) {
  EXPECT_DOUBLE_EQ(distance_m(kTriangle, {1, 0.5}), 0.0);
  EXPECT_DOUBLE_EQ(distance_m(kTriangle, {1, -3}), 3.0);
  EXPECT_NEAR(distance_m(kTriangle, {4, 2}), 4 / std::sqrt(5.0), 1e-6);  // the long side is x / 4 + y / 2 = 1
  EXPECT_GT(distance_m({}, {0, 0}), 1e9);
}

TEST(ZoneType, IsNamedAsInFiles) {
  EXPECT_EQ(toString(ZoneType::OneWay), "one_way");
  for (const auto type :
       {ZoneType::Place, ZoneType::Forbidden, ZoneType::Slow, ZoneType::OneWay, ZoneType::Action, ZoneType::Release}) {
    EXPECT_EQ(zoneTypeFrom(toString(type)), type);
  }
  EXPECT_FALSE(zoneTypeFrom("Slow"));
}

TEST(ZoneType, SelectsZonesInTheirOrder) {
  const std::vector<Zone> zones{{"a", {}, ZoneType::Slow}, {"b", {}}, {"c", {}, ZoneType::Slow}};
  const auto slow = zonesOfType(zones, ZoneType::Slow);
  ASSERT_EQ(slow.size(), 2U);
  EXPECT_EQ(slow[0].name, "a");
  EXPECT_EQ(slow[1].name, "c");
}

}  // namespace
}  // namespace wardslam::mapping
