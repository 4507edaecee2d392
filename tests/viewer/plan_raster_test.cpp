#include "wardslam/viewer/plan_raster.h"

#include <gtest/gtest.h>

#include "support/hand_made_map.h"
#include "wardslam/viewer/plan_picture.h"

namespace wardslam::viewer {
namespace {

TEST(PlanRaster, IsThatOfThePicture) {
  const auto ward = test::makeWard();
  EXPECT_EQ(PlanRaster(ward).size(), drawPlan(ward).size());
}

TEST(PlanRaster, PutsYUpwards) {
  mapping::SemanticMap map;
  map.floorPlan = test::makeFloorPlan();  // 8 m by 6 m from (-1, -1), and 0.3 m around it
  const PlanRaster raster(map);
  EXPECT_EQ(raster.at({-1.3, 5.3}), cv::Point(0, 0));
  EXPECT_EQ(raster.at({-0.3, 5.3}), cv::Point(raster.toPixels(1.0), 0));
  EXPECT_EQ(raster.at({-1.3, 4.3}), cv::Point(0, raster.toPixels(1.0)));
  EXPECT_EQ(raster.toPixels(1.0), 160);
}

}  // namespace
}  // namespace wardslam::viewer
