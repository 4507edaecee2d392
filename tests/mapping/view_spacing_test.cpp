#include "wardslam/mapping/view_spacing.h"

#include <gtest/gtest.h>

namespace wardslam::mapping {
namespace {

TEST(ViewSpacing, StepTurnOrTimeIsEnough) {
  const ViewOptions options{0.1, 0.06, 0.5};
  core::StampedPose last;
  last.T_map_cam = Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitY());
  core::StampedPose now = last;
  now.stamp_s = 0.4;
  EXPECT_FALSE(isFarEnough(options, last, now));
  now.stamp_s = 0.5;
  EXPECT_TRUE(isFarEnough(options, last, now));
  now = last;
  now.T_map_cam.translation().z() += 0.099;
  EXPECT_FALSE(isFarEnough(options, last, now));
  now.T_map_cam.translation().z() += 0.002;
  EXPECT_TRUE(isFarEnough(options, last, now));
  now = last;
  now.T_map_cam.rotate(Eigen::AngleAxisd(0.059, Eigen::Vector3d::UnitX()));
  EXPECT_FALSE(isFarEnough(options, last, now));
  now.T_map_cam.rotate(Eigen::AngleAxisd(0.002, Eigen::Vector3d::UnitX()));
  EXPECT_TRUE(isFarEnough(options, last, now));
}

}  // namespace
}  // namespace wardslam::mapping
