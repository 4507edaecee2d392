#include "wardslam/building/rooms_of_map.h"

#include <gtest/gtest.h>

namespace wardslam::building {
namespace {

/// Two rooms of 4 x 4 m side by side, a wall of 0.2 m between them, and along that wall a bench of 3 m, whose middle is
/// at `bench_m`. A keyframe saw a floor at 0, three another at 3.6 m, where the plan is of the lower one or the upper.
mapping::SemanticMap makeMap(double bench_m) {
  mapping::SemanticMap map;
  map.floorPlan.resolution_m = 0.1;
  map.floorPlan.cells = cv::Mat(40, 82, CV_8UC1, cv::Scalar(mapping::FloorPlan::kFree));
  map.floorPlan.cells.colRange(40, 42) = mapping::FloorPlan::kOccupied;
  for (std::uint64_t id = 1; id <= 4; ++id) {
    auto& keyframe = map.keyframes[id];
    keyframe.T_map_cam.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    keyframe.T_map_cam.translation().z() = 1.2 + (id == 1 ? 0.0 : 3.6);
    keyframe.ground = core::GroundPlane{-Eigen::Vector3d::UnitY(), 1.2, Eigen::Matrix3d::Zero()};
  }
  mapping::MapObject& bench = map.objects[1];
  bench.id = 1;
  bench.centroid_m = {4.1, 2.0, bench_m};
  bench.orientedBox.T_map_box.translation() = bench.centroid_m;
  bench.orientedBox.size_m = {0.6, 3.0, 0.8};
  return map;
}

TEST(RoomsOfMapTest, AThingOnAnotherStoreyStandsInNoRoom) {
  EXPECT_EQ(roomsOf(makeMap(4.0)).all.size(), 1U) << "what stands where the plan is of is no wall";
  EXPECT_EQ(roomsOf(makeMap(0.4)).all.size(), 2U);
}

}  // namespace
}  // namespace wardslam::building
