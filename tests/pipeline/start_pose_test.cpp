#include "wardslam/pipeline/start_pose.h"

#include <gmock/gmock.h>

#include <opencv2/core.hpp>

#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::pipeline {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// A level camera on a robot's mast, 1 m over the floor, or before a wall.
core::Frame frameOf(bool showsFloor) {
  core::Frame frame;
  frame.depth_m = cv::Mat(480, 640, CV_32FC1, cv::Scalar(3.0));
  if (showsFloor) {
    for (int y = 300; y < 480; ++y) {
      frame.depth_m.row(y) = 1.0 / ((y - frame.camera.cy_px) / frame.camera.fy_px);
    }
  }
  frame.T_base_cam = Eigen::Translation3d(0.2, 0.0, 1.3) * core::T_sensor_cam();
  return frame;
}

TEST(StartPose, IsTheCameraOnTheRobotWithTheFloorAtZero) {
  const Eigen::Isometry3d T = startPose({}, frameOf(true));
  EXPECT_TRUE(T.translation().isApprox(Eigen::Vector3d(0.2, 0.0, 1.0), 5e-3)) << T.translation();
  EXPECT_TRUE(T.linear().isApprox(core::T_sensor_cam().linear(), 5e-3));
}

TEST(StartPose, WithoutAFloorIsTheCameraOnTheRobot) {
  EXPECT_TRUE(startPose({}, frameOf(false)).isApprox(frameOf(false).T_base_cam));
  MapFrameOptions unlevelled;
  unlevelled.level_with_floor = false;
  EXPECT_TRUE(startPose(unlevelled, frameOf(true)).isApprox(frameOf(true).T_base_cam));
}

TEST(StartPose, CanBeGiven) {
  MapFrameOptions options;
  options.start_pose = "1 2 3 0 0 0.70711 0.70711";
  const Eigen::Isometry3d T = startPose(options, frameOf(true));
  EXPECT_TRUE(T.isApprox(Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()), 1e-5));
}

TEST(StartPose, LiesWhereCoordinatesAreExact) {
  MapFrameOptions options;
  options.start_pose = "600 -799 1 0 0 0 1";
  EXPECT_NO_THROW(requireValid(options));
  for (const char* far : {"600 -801 1 0 0 0 1", "450000 5400000 100 0 0 0 1", "1e300 0 0 0 0 0 1"}) {
    options.start_pose = far;
    EXPECT_THAT([&] { requireValid(options); },
                ThrowsMessage<core::InputError>(AllOf(HasSubstr("map_frame.start_pose"), HasSubstr("1000 m"))))
        << far;
  }
}

TEST(StartPose, SaysWhatAPoseIs) {
  for (const char* wrong : {"1 2 3", "1 2 3 0 0 0 0", "1 2 3 0 0 0 1 7", "a b c 0 0 0 1", "nan 0 0 0 0 0 nan"}) {
    MapFrameOptions options;
    options.start_pose = wrong;
    EXPECT_THAT([&] { requireValid(options); },
                ThrowsMessage<core::InputError>(AllOf(HasSubstr("map_frame.start_pose"), HasSubstr("seven numbers"))))
        << wrong;
  }
}

TEST(StartPose, OfAProgramThatKnowsWhereTheRobotStands) {
  MapFrameOptions options;
  options.level_with_floor = false;
  options.T_map_base = Eigen::Translation3d(3.0, -2.0, 0.0) * Eigen::AngleAxisd(M_PI / 2.0, Eigen::Vector3d::UnitZ());
  core::Frame frame;
  frame.T_base_cam = Eigen::Translation3d(0.2, 0.0, 1.1) * Eigen::Isometry3d::Identity();
  EXPECT_TRUE(startPose(options, frame).translation().isApprox(Eigen::Vector3d(3.0, -1.8, 1.1), 1e-12));
  options.start_pose = "0 0 0 0 0 0 1";
  EXPECT_TRUE(startPose(options, frame).isApprox(Eigen::Isometry3d::Identity())) << "what the user says overrules it";
}

}  // namespace
}  // namespace wardslam::pipeline
