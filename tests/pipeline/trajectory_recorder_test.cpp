#include "wardslam/pipeline/trajectory_recorder.h"

#include <gmock/gmock.h>

#include <memory>

namespace wardslam::pipeline {
namespace {

Eigen::Isometry3d at(double x_m, double y_m, double yaw_rad = 0.0) {
  return Eigen::Translation3d(x_m, y_m, 0.0) * Eigen::Isometry3d(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
}

void record(TrajectoryRecorder& recorder, double stamp_s, odometry::State state, odometry::KeyframeId keyframe,
            const Eigen::Isometry3d& T_keyframe_cam) {
  core::Frame frame;
  frame.stamp_s = stamp_s;
  odometry::OdometryResult odometry;
  odometry.state = state;
  odometry.referenceKeyframe = keyframe;
  odometry.T_keyframe_cam = T_keyframe_cam;
  odometry.T_map_cam = at(100, 100);  // as it was thought then: of no use later
  recorder.onFrame(frame, odometry);
}

/// As they were measured.
odometry::SmoothingOptions unsmoothed() {
  odometry::SmoothingOptions options;
  options.velocity_change_mps = 0.0;
  options.longest_bridge_s = 1.5;
  return options;
}

TEST(TrajectoryRecorder, FramesFollowTheirKeyframes) {
  TrajectoryRecorder recorder;
  record(recorder, 1.0, odometry::State::Ok, 1, at(0, 0));
  record(recorder, 2.0, odometry::State::Ok, 1, at(1, 0));
  record(recorder, 3.0, odometry::State::Lost, 1, at(9, 9));
  record(recorder, 4.0, odometry::State::Ok, 2, at(1, 0));
  const auto trajectory = recorder.corrected({{1, at(5, 0)}, {2, at(0, 7, M_PI / 2)}});
  ASSERT_EQ(trajectory.size(), 3U) << "nothing where the camera was lost";
  EXPECT_EQ(trajectory[1].stamp_s, 2.0);
  EXPECT_EQ(trajectory[2].stamp_s, 4.0);
  EXPECT_TRUE(trajectory[0].T_map_cam.isApprox(at(5, 0)));
  EXPECT_TRUE(trajectory[1].T_map_cam.isApprox(at(6, 0)));
  EXPECT_TRUE(trajectory[2].T_map_cam.isApprox(at(0, 8, M_PI / 2))) << "a step ahead of a keyframe turned left";
  const auto later = recorder.corrected({{1, at(0, 0)}, {2, at(0, 0)}});
  EXPECT_TRUE(later[2].T_map_cam.isApprox(at(1, 0))) << "by where the keyframes are now";
}

TEST(TrajectoryRecorder, BridgesAMomentInWhichTheCameraWasLost) {
  TrajectoryRecorder recorder(unsmoothed());
  record(recorder, 1.0, odometry::State::Ok, 1, at(0, 0));
  record(recorder, 1.5, odometry::State::Lost, 1, at(9, 9));
  record(recorder, 2.0, odometry::State::Ok, 2, at(1, 0));
  const auto trajectory = recorder.onOneWay({{1, at(5, 0)}, {2, at(6, 0)}});
  ASSERT_EQ(trajectory.size(), 3U);
  EXPECT_TRUE(trajectory[1].isBridged);
  EXPECT_TRUE(trajectory[1].T_map_cam.isApprox(at(6, 0))) << "half way from 5 to 7";
  EXPECT_FALSE(trajectory[2].isBridged);
  EXPECT_EQ(recorder.corrected({{1, at(5, 0)}, {2, at(6, 0)}}).size(), 2U) << "while a run goes on, what was tracked";
}

/// Of nine frames on the way the middle one is 5 cm off, and says that it is not sure.
void recordAnUnsureOne(TrajectoryRecorder& recorder, const std::shared_ptr<const odometry::Keyframe>& keyframe = {}) {
  for (int i = 0; i < 9; ++i) {
    core::Frame frame;
    frame.stamp_s = 1.0 + 0.1 * i;
    odometry::OdometryResult odometry;
    odometry.state = odometry::State::Ok;
    odometry.referenceKeyframe = i == 4 && keyframe ? 2 : 1;
    odometry.T_keyframe_cam = i == 4 && keyframe ? at(0, 0) : at(0.1 * i, i == 4 ? 0.05 : 0.0);
    odometry.covariance = odometry::PoseCovariance::Identity() * (i == 4 ? 0.01 : 1e-6);
    if (i == 4) odometry.keyframe = keyframe;
    recorder.onFrame(frame, odometry);
  }
}

TEST(TrajectoryRecorder, MeasuresCountAsTheyAreSure) {
  TrajectoryRecorder recorder;
  recordAnUnsureOne(recorder);
  const auto trajectory = recorder.onOneWay({{1, at(0, 0)}});
  ASSERT_EQ(trajectory.size(), 9U);
  EXPECT_NEAR(trajectory[4].T_map_cam.translation().y(), 0.0, 0.005) << "it was not sure at all";
}

TEST(TrajectoryRecorder, TheWayLeadsThroughKeyframes) {
  TrajectoryRecorder recorder;
  recordAnUnsureOne(recorder, std::make_shared<odometry::Keyframe>());
  const auto through = recorder.onOneWay({{1, at(0, 0)}, {2, at(0.4, 0.05)}});
  EXPECT_TRUE(through.at(4).T_map_cam.isApprox(at(0.4, 0.05), 1e-12)) << "where it is in the map";
  odometry::MapUpdate update;
  update.removedKeyframes = {{2, 1, at(0.4, 0.05)}};
  recorder.onUpdate(update);
  const auto by = recorder.onOneWay({{1, at(0, 0)}});
  EXPECT_NEAR(by.at(4).T_map_cam.translation().y(), 0.0, 0.005) << "it is a frame as others now";
}

TEST(TrajectoryRecorder, FramesOfARemovedKeyframeHangOnItsHeir) {
  TrajectoryRecorder recorder;
  record(recorder, 1.0, odometry::State::Ok, 1, at(0, 0));
  record(recorder, 2.0, odometry::State::Ok, 2, at(1, 0));
  record(recorder, 3.0, odometry::State::Ok, 3, at(1, 0));
  record(recorder, 4.0, odometry::State::Ok, 1, at(4, 0));
  odometry::MapUpdate update;
  update.removedKeyframes = {{3, 2, at(0, 1)}, {2, 1, at(1, 0, M_PI / 2)}, {9, 1, at(0, 0)}};
  recorder.onUpdate(update);
  const auto trajectory = recorder.corrected({{1, at(10, 0)}});
  ASSERT_EQ(trajectory.size(), 4U);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(trajectory[static_cast<std::size_t>(i)].stamp_s, i + 1.0) << "in order of time";
  EXPECT_TRUE(trajectory[1].T_map_cam.isApprox(at(11, 1, M_PI / 2)));
  EXPECT_TRUE(trajectory[2].T_map_cam.isApprox(at(10, 1, M_PI / 2))) << "by way of an heir that was removed itself";
  EXPECT_TRUE(trajectory[3].T_map_cam.isApprox(at(14, 0)));
}

}  // namespace
}  // namespace wardslam::pipeline
