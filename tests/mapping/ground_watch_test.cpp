#include "wardslam/mapping/ground_watch.h"

#include <gtest/gtest.h>

#include "mapping/scene.h"

namespace wardslam::mapping {
namespace {

/// Level ground at `z_m`, in sight or not.
cv::Mat groundAt(double z_m, const Eigen::Isometry3d& T_map_cam) {
  const core::CameraModel camera = scene::camera();
  cv::Mat depth_m(camera.height_px, camera.width_px, CV_32FC1, cv::Scalar(0));
  for (int v = 0; v < depth_m.rows; ++v) {
    for (int u = 0; u < depth_m.cols; ++u) {
      const Eigen::Vector3d ray = T_map_cam.linear() * camera.unproject({u, v}, 1.0);
      const double range_m = (z_m - T_map_cam.translation().z()) / ray.z();
      if (range_m > 0.0 && range_m < 6.0) depth_m.at<float>(v, u) = static_cast<float>(range_m);
    }
  }
  return depth_m;
}

class GroundWatchTest : public ::testing::Test {
 protected:
  /// The ground that the next keyframe is told to see.
  std::optional<core::GroundPlane> see(double z_m, double step_m = 0.3, std::uint32_t submap = 1) {
    odometry::Keyframe keyframe;
    keyframe.id = ++id_;
    keyframe.submap = submap;
    keyframe.camera = scene::camera();
    keyframe.T_previous_cam = Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, step_m));
    keyframe.T_map_cam = scene::cameraAt({0, 0, 1.0});
    const auto seen =
        watch_.look(std::make_shared<const odometry::Keyframe>(keyframe), groundAt(z_m, keyframe.T_map_cam));
    EXPECT_EQ(seen->id, id_);
    return seen->ground;
  }

  GroundWatch watch_;
  odometry::KeyframeId id_ = 0;
};

TEST_F(GroundWatchTest, SeesTheGround) {
  const auto ground = see(0.0);
  ASSERT_TRUE(ground);
  EXPECT_NEAR(ground->height_m, 1.0, 0.005);
  EXPECT_LT((ground->normal_cam + Eigen::Vector3d::UnitY()).norm(), 0.005);
  EXPECT_FALSE(see(-20.0)) << "beyond range";
}

TEST_F(GroundWatchTest, ExpectsItWhereItWas) {
  ASSERT_TRUE(see(0.0));
  EXPECT_FALSE(see(0.4)) << "a table top, which nothing is beneath of";
  EXPECT_TRUE(see(0.0));
}

TEST_F(GroundWatchTest, IsLessSureFartherOn) {
  ASSERT_TRUE(see(0.0));
  EXPECT_TRUE(see(0.4, 3.0)) << "3 m of a ramp lead there";
}

/// Tracking was lost, and the camera tilted meanwhile.
TEST_F(GroundWatchTest, PlacesWhoBeginsAnewUprightOverTheGround) {
  const Eigen::Isometry3d truth = scene::cameraAt({7.0, -2.0, 1.3}) * Eigen::AngleAxisd(0.07, Eigen::Vector3d::UnitX());
  const Eigen::Isometry3d believed = scene::cameraAt({0.0, 0.0, 1.0});
  const cv::Mat depth_m = groundAt(0.0, truth);
  EXPECT_TRUE(watch_.placeAnew(believed, scene::camera(), depth_m).isApprox(believed)) << "nothing is known";
  ASSERT_TRUE(see(0.0));
  const Eigen::Isometry3d placed = watch_.placeAnew(believed, scene::camera(), depth_m);
  EXPECT_LT((placed.linear() - truth.linear()).norm(), 0.01) << "0.1 without";
  EXPECT_LT((placed.translation() - Eigen::Vector3d(0.0, 0.0, 1.3)).norm(), 0.01) << "where it goes on nobody knows";
  const cv::Mat nothing(depth_m.size(), CV_32FC1, cv::Scalar(0));
  EXPECT_TRUE(watch_.placeAnew(believed, scene::camera(), nothing).isApprox(believed));
}

/// By a start pose that is tilted, or since the map was joined to another.
TEST_F(GroundWatchTest, PlacesThemOverTheGroundAsItLiesInTheMap) {
  ASSERT_TRUE(see(0.0));
  const Eigen::Isometry3d leaning = Eigen::Translation3d(3.0, 1.0, 0.5) *
                                    Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()) *
                                    Eigen::AngleAxisd(0.1, Eigen::Vector3d(1.0, 2.0, 0.0).normalized());
  watch_.follow(leaning);
  const Eigen::Isometry3d truth = leaning * scene::cameraAt({0.5, 0.3, 1.2});
  const Eigen::Isometry3d believed = truth * Eigen::AngleAxisd(-0.05, Eigen::Vector3d::UnitX());
  const Eigen::Isometry3d placed =
      watch_.placeAnew(believed, scene::camera(), groundAt(0.0, scene::cameraAt({0.5, 0.3, 1.2})));
  EXPECT_LT((placed.linear() - truth.linear()).norm(), 0.01);
  EXPECT_LT((placed.translation() - truth.translation()).norm(), 0.01);
}

TEST_F(GroundWatchTest, BeginsAnewWhereTrackingDoes) {
  ASSERT_TRUE(see(0.0));
  EXPECT_TRUE(see(0.4, 0.3, 2));
}

}  // namespace
}  // namespace wardslam::mapping
