#include "wardslam/mapping/zone.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace wardslam::mapping
