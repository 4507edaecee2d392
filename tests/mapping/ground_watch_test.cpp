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

TEST_F(GroundWatchTest, BeginsAnewWhereTrackingDoes) {
  ASSERT_TRUE(see(0.0));
  EXPECT_TRUE(see(0.4, 0.3, 2));
}

}  // namespace
}  // namespace wardslam::mapping
