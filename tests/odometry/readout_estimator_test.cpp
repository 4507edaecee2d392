#include "readout_estimator.h"

#include <gtest/gtest.h>

#include "odometry/rolling_world.h"

namespace wardslam::odometry {
namespace {

const core::CameraModel kCamera;
constexpr double kUnknown_s = 0.015;

/// All that is in sight, as the image shows it whose middle row is read then.
std::map<PointId, SeenPoint> look(test::RollingWorld& world, double t_s, double pixel_px) {
  std::map<PointId, SeenPoint> points;
  for (std::size_t i = 0; i < world.size(); ++i) {
    core::Keypoint keypoint;
    if (!world.see(i, t_s, pixel_px, keypoint)) continue;
    points[i + 1] = {{keypoint.undistorted_px.x, keypoint.undistorted_px.y},
                     static_cast<double>(keypoint.depth_m),
                     1.0,
                     rowTime(static_cast<double>(keypoint.raw_px.y), kCamera)};
  }
  return points;
}

/// Shows it `images` images of a world with this readout; poses are those of the middle rows.
void show(ReadoutEstimator& estimator, double readout_s, int images, double pixel_px = 0.5, double rate_hz = 30.0) {
  test::RollingWorld world(readout_s);
  for (int image = 0; image < images; ++image) {
    const double t_s = image / rate_hz;
    estimator.observe(t_s, test::RollingWorld::T_world_cam(t_s), kCamera, look(world, t_s, pixel_px));
  }
}

double found_s(double readout_s) {
  ReadoutEstimator estimator(0.0, kUnknown_s);
  show(estimator, readout_s, 90);
  return estimator.readout_s();
}

TEST(ReadoutEstimator, FindsHowLongAnImageTakes) {
  EXPECT_NEAR(found_s(0.030), 0.030, 0.0015);
  EXPECT_NEAR(found_s(0.015), 0.015, 0.0015);
  EXPECT_NEAR(found_s(-0.020), -0.020, 0.0015) << "read from below";
}

TEST(ReadoutEstimator, OfAGlobalShutterThereIsNone) { EXPECT_NEAR(found_s(0.0), 0.0, 0.0005); }

TEST(ReadoutEstimator, IsAsSureAsItIsRight) {
  ReadoutEstimator estimator(0.0, kUnknown_s);
  EXPECT_DOUBLE_EQ(estimator.readout_s(), 0.0);
  EXPECT_DOUBLE_EQ(estimator.sigma_s(), kUnknown_s);
  show(estimator, 0.030, 30);
  const double after1s = estimator.sigma_s();
  EXPECT_LT(after1s, 0.003);
  EXPECT_LT(std::abs(estimator.readout_s() - 0.030), 3 * after1s);
}

TEST(ReadoutEstimator, BelievesWhatIsKnownBeforehand) {
  ReadoutEstimator estimator(0.0305, 1e-6);
  show(estimator, 0.0, 30);
  EXPECT_NEAR(estimator.readout_s(), 0.0305, 1e-4);
}

TEST(ReadoutEstimator, LearnsNothingAcrossGapsNorFromFewPoints) {
  ReadoutEstimator slow(0.0, kUnknown_s);
  show(slow, 0.030, 30, 0.5, 2.0);
  EXPECT_DOUBLE_EQ(slow.sigma_s(), kUnknown_s);
  ReadoutEstimator blind(0.0, kUnknown_s);
  for (int image = 0; image < 10; ++image) blind.observe(image / 30.0, Eigen::Isometry3d::Identity(), kCamera, {});
  EXPECT_DOUBLE_EQ(blind.sigma_s(), kUnknown_s);
}

TEST(ReadoutEstimator, AStandingCameraTellsNothing) {
  ReadoutEstimator estimator(0.0, kUnknown_s);
  std::map<PointId, SeenPoint> points;
  for (std::size_t i = 1; i <= 100; ++i) {
    const double x_px = 6.0 * static_cast<double>(i);
    const double y_px = static_cast<double>((i * 97) % 480);
    points[i] = {{x_px, y_px}, 2.0, 1.0, rowTime(y_px, kCamera)};
  }
  for (int image = 0; image < 30; ++image)
    estimator.observe(image / 30.0, Eigen::Isometry3d::Identity(), kCamera, points);
  EXPECT_NEAR(estimator.readout_s(), 0.0, 1e-9);
  EXPECT_NEAR(estimator.sigma_s(), kUnknown_s, 1e-6);
}

TEST(ReadoutEstimator, ACorrectionOfTheMapIsNoMotion) {
  const auto run = [](bool corrects) {
    ReadoutEstimator estimator(0.0, kUnknown_s);
    test::RollingWorld world(0.030);
    Eigen::Isometry3d correction = Eigen::Isometry3d::Identity();
    for (int image = 0; image < 60; ++image) {
      const double t_s = image / 30.0;
      if (corrects && image % 7 == 0) {
        Eigen::Isometry3d jump(Eigen::AngleAxisd(0.02, Eigen::Vector3d::UnitY()));
        jump.translation() = Eigen::Vector3d(0.05, 0.0, 0.02);
        correction = jump * correction;
        estimator.move(jump);
      }
      estimator.observe(t_s, correction * test::RollingWorld::T_world_cam(t_s), kCamera, look(world, t_s, 0.0));
    }
    return estimator.readout_s();
  };
  EXPECT_NEAR(run(true), run(false), 1e-6);
}

}  // namespace
}  // namespace wardslam::odometry
