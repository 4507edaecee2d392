#include "placed_keyframes.h"

#include <gtest/gtest.h>

namespace wardslam::mapping {
namespace {

Eigen::Isometry3d at(double x_m) { return Eigen::Isometry3d(Eigen::Translation3d(x_m, 0, 0)); }

/// Keyframes 1 and 2 of piece 7 at 1 m and 2 m, 3 of piece 8 at 3 m; at 10, 20 and 30 s.
PlacedKeyframes threeKeyframes() {
  PlacedKeyframes keyframes;
  keyframes[1] = {7, 10.0, at(1), {}, {}};
  keyframes[2] = {7, 20.0, at(2), {}, {}};
  keyframes[3] = {8, 30.0, at(3), {}, {}};
  return keyframes;
}

TEST(PlacedKeyframesTest, OneIsPlacedByTheOneBeforeItInItsPiece) {
  odometry::Keyframe keyframe;
  keyframe.id = 3;
  keyframe.T_map_cam = at(9);
  keyframe.T_previous_cam = at(0.5);
  EXPECT_EQ(placeOf(keyframe, 7, threeKeyframes()).translation().x(), 2.5);
  EXPECT_EQ(placeOf(keyframe, 8, threeKeyframes()).translation().x(), 9.0) << "the one before is of another piece";
  keyframe.T_previous_cam.reset();
  EXPECT_EQ(placeOf(keyframe, 7, threeKeyframes()).translation().x(), 9.0);
}

TEST(PlacedKeyframesTest, YoungerOnesOfThePieceMoveAsTheNewestDoes) {
  odometry::MapUpdate update;
  update.newestKeyframe = 1;
  update.T_map_cam[1] = at(1.25);
  const auto moved = withYounger(update, threeKeyframes());
  ASSERT_EQ(moved.size(), 2U) << "what is of another piece stays";
  EXPECT_EQ(moved.at(2).translation().x(), 2.25);
}

TEST(PlacedKeyframesTest, TheLastStampIsThatOfThePiece) {
  EXPECT_EQ(lastStampOf(7, threeKeyframes()), 20.0);
  EXPECT_EQ(lastStampOf(8, threeKeyframes()), 30.0);
  EXPECT_EQ(lastStampOf(9, threeKeyframes()), 0.0);
}

}  // namespace
}  // namespace wardslam::mapping
