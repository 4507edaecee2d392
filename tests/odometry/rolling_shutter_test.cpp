#include "rolling_shutter.h"

#include <gtest/gtest.h>

#include "odometry/odometry_fixture.h"
#include "odometry/rolling_world.h"

namespace wardslam::odometry {
namespace {

const core::CameraModel kCamera;

TEST(Rectified, MovesKeyPointsByWhatTheCameraTurnedMeanwhile) {
  core::Features features;
  for (const float y_px : {0.0F, 239.5F, 479.0F}) {
    core::Keypoint keypoint;
    keypoint.raw_px = keypoint.undistorted_px = {319.5F, y_px};
    keypoint.depth_m = 2.0F;
    features.keypoints.push_back(keypoint);
  }
  Twist twist;
  twist.rotation_radps = {0.0, 0.5, 0.0};  // to the right
  const auto still = rectified(features, kCamera, twist, 0.03).keypoints;
  // The first row is read 15 ms early, 7.5 mrad before: there the point stood farther to the right than it does in the
  // middle of the readout. 525 px * 0.0075 / cos(24.5 deg) of the ray's length over its depth: 0.0075 * 1 per depth.
  EXPECT_NEAR(still[0].undistorted_px.x, 319.5 - 3.93, 0.02);
  EXPECT_NEAR(still[1].undistorted_px.x, 319.5, 1e-3) << "the middle row is read in the middle";
  EXPECT_NEAR(still[2].undistorted_px.x, 319.5 + 3.93, 0.02);
  EXPECT_EQ(still[0].raw_px.x, 319.5F) << "where it was recorded";
}

TEST(Rectified, GoingAheadBringsWhatIsReadLateNearer) {
  core::Features features;
  core::Keypoint keypoint;
  keypoint.raw_px = keypoint.undistorted_px = {419.5F, 479.0F};
  keypoint.depth_m = 1.0F;
  features.keypoints.push_back(keypoint);
  keypoint.depth_m = 0.0F;
  features.keypoints.push_back(keypoint);
  Twist twist;
  twist.translation_mps = {0.0, 0.0, 1.0};
  const auto still = rectified(features, kCamera, twist, 0.03).keypoints;
  // Read 14.97 ms late, when the camera was 14.97 mm nearer.
  EXPECT_NEAR(still[0].depth_m, 1.01497F, 1e-4F);
  EXPECT_NEAR(still[0].undistorted_px.x, 319.5 + 100.0 / 1.01497, 0.01);
  EXPECT_EQ(still[1].depth_m, 0.0F);
  EXPECT_NEAR(still[1].undistorted_px.x, 419.5, 1e-3) << "how far it is nobody knows";
}

TEST(RollingShutter, DoesNothingAsLongAsNothingIsKnown) {
  core::Features features;
  features.keypoints.resize(1);
  features.keypoints[0].undistorted_px = {10.0F, 20.0F};
  RollingShutter shutter(RollingShutterOptions{});
  Eigen::Isometry3d turn(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY()));
  shutter.moved(turn, 0.03);
  EXPECT_EQ(shutter.rectified(features, kCamera).keypoints[0].undistorted_px.x, 10.0F);

  RollingShutter known(RollingShutterOptions{false, 0.03, 1e-6});
  known.moved(turn, 0.03);
  EXPECT_NE(known.rectified(features, kCamera).keypoints[0].undistorted_px.x, 10.0F);
  for (const double since_s : {0.0, -0.1, 1.0}) {
    known.moved(turn, since_s);
    EXPECT_EQ(known.rectified(features, kCamera).keypoints[0].undistorted_px.x, 10.0F) << since_s;
  }
}

TEST(RollingShutter, TakesWhatACalibrationSaysUnlessTheOptionsDo) {
  core::CameraModel camera;
  camera.readout_s = 0.03;
  RollingShutter shutter(RollingShutterOptions{});
  shutter.begin(camera);
  EXPECT_DOUBLE_EQ(shutter.readout_s(), 0.03);
  camera.readout_s = 0.02;
  shutter.begin(camera);
  EXPECT_DOUBLE_EQ(shutter.readout_s(), 0.03) << "the first camera's";

  RollingShutter told(RollingShutterOptions{true, 0.025, 1e-6});
  told.begin(camera);
  EXPECT_DOUBLE_EQ(told.readout_s(), 0.025);
}

/// Root of the mean square of the distance from the true way of the middle rows.
double errorOfTracking(bool learns, double readout_s, double& found_s, const core::CameraModel& camera = kCamera) {
  test::RollingWorld world(readout_s, 2500);
  std::mt19937 random(7);
  std::vector<OrbDescriptor> descriptors(world.size());
  for (auto& descriptor : descriptors) {
    for (auto& byte : descriptor) byte = static_cast<std::uint8_t>(random());
  }
  OdometryOptions options;
  options.rolling_shutter.learn = learns;
  Odometry odometry(options);
  const Eigen::Isometry3d T_start = test::RollingWorld::T_world_cam(0.0);
  double squares_m2 = 0.0;
  constexpr int kFrames = 120;
  for (int image = 0; image < kFrames; ++image) {
    const double t_s = image / 30.0;
    core::Features features;
    for (std::size_t i = 0; i < world.size(); ++i) {
      core::Keypoint keypoint;
      if (!world.see(i, t_s, 0.3, keypoint)) continue;
      features.keypoints.push_back(keypoint);
      features.descriptors.push_back(cv::Mat(1, 32, CV_8UC1, descriptors[i].data()));
    }
    const auto result = odometry.track(t_s, camera, features);
    EXPECT_TRUE(result.hasPose()) << image;
    squares_m2 += std::pow(distance_m(result.T_map_cam, T_start.inverse() * test::RollingWorld::T_world_cam(t_s)), 2);
    found_s = result.readout_s;
  }
  return std::sqrt(squares_m2 / kFrames);
}

TEST(RollingShutter, TrackingLearnsItAndIsTheBetterForIt) {
  double found_s = 0.0;
  const double without_m = errorOfTracking(false, 0.030, found_s);
  EXPECT_EQ(found_s, 0.0);
  const double with_m = errorOfTracking(true, 0.030, found_s);
  EXPECT_NEAR(found_s, 0.030, 0.006);
  EXPECT_LT(with_m, 0.5 * without_m);
}

TEST(RollingShutter, ToldByTheCalibrationItHelpsAsMuchAndNothingIsLearned) {
  double found_s = 0.0;
  const double without_m = errorOfTracking(false, 0.030, found_s);
  core::CameraModel calibrated = kCamera;
  calibrated.readout_s = 0.030;
  const double told_m = errorOfTracking(true, 0.030, found_s, calibrated);
  EXPECT_DOUBLE_EQ(found_s, 0.030);
  EXPECT_LT(told_m, 0.5 * without_m);
}

TEST(RollingShutter, CostsAGlobalShutterNothing) {
  double found_s = 0.0;
  const double without_m = errorOfTracking(false, 0.0, found_s);
  const double with_m = errorOfTracking(true, 0.0, found_s);
  EXPECT_NEAR(found_s, 0.0, 0.002);
  EXPECT_LT(with_m, 1.2 * without_m + 0.0005);
}

}  // namespace
}  // namespace wardslam::odometry
