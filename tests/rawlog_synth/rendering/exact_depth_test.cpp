#include "rendering/exact_depth.h"

#include <gtest/gtest.h>

#include "wardslam/core/camera_model.h"

namespace wardslam::synth {
namespace {

/// World frame = camera frame turned so that the test sees real transformations: p_world = T p_cam.
Eigen::Isometry3d somePose() {
  return Eigen::Translation3d(1, -2, 0.5) * Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 2, -1).normalized());
}

/// A large triangle on the plane n p = d of the camera frame.
Mesh planeInFrontOf(const Eigen::Isometry3d& T_world_cam, const Eigen::Vector3d& n, double d) {
  Mesh mesh;
  for (const Eigen::Vector2d& xy : {Eigen::Vector2d(-50, -50), Eigen::Vector2d(50, -50), Eigen::Vector2d(0, 50)}) {
    const Eigen::Vector3d p_cam(xy.x(), xy.y(), (d - n.head<2>().dot(xy)) / n.z());
    mesh.vertices.push_back({(T_world_cam * p_cam).cast<float>(), Eigen::Vector3f::UnitZ(), Eigen::Vector2f::Zero()});
  }
  return mesh;
}

TEST(ExactDepth, CutsRaysWithASlantedPlane) {
  const core::CameraModel camera;
  const Eigen::Vector3d n(0.2, -0.3, 1.0);
  const Mesh mesh = planeInFrontOf(somePose(), n, 4.0);
  ExactDepth depth(somePose());
  for (const auto& [x, y] : {std::pair(0, 0), {639, 0}, {100, 470}, {320, 240}}) {
    const Eigen::Vector3d ray = camera.unproject(Eigen::Vector2d(x, y), 1.0);
    EXPECT_NEAR(depth.of(mesh.vertices.data(), ray), 4.0 / n.dot(ray), 1e-4);
  }
}

TEST(ExactDepth, KeepsToTheTriangleSeenEdgeOn) {
  const core::CameraModel camera;
  Mesh mesh;  // in the plane x = 0.001, which the rays of the middle column hardly meet
  for (const Eigen::Vector3f& p :
       {Eigen::Vector3f(0.001F, -1, 2), Eigen::Vector3f(0.001F, 1, 2), Eigen::Vector3f(0.001F, 0, 3)}) {
    mesh.vertices.push_back({p, Eigen::Vector3f::UnitX(), Eigen::Vector2f::Zero()});
  }
  ExactDepth depth(Eigen::Isometry3d::Identity());
  for (const int x : {300, 319, 320, 321, 400}) {
    const float depth_m = depth.of(mesh.vertices.data(), camera.unproject(Eigen::Vector2d(x, 240), 1.0));
    EXPECT_GE(depth_m, 2.0F);
    EXPECT_LE(depth_m, 3.0F);
  }
}

TEST(ExactDepth, LooksAtEachTriangleAnew) {
  const Mesh near = planeInFrontOf(somePose(), {0, 0, 1}, 2.0);
  const Mesh far = planeInFrontOf(somePose(), {0, 0, 1}, 5.0);
  ExactDepth depth(somePose());
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(depth.of(near.vertices.data(), {0.1, 0.2, 1}), 2.0F, 1e-5F);
    EXPECT_NEAR(depth.of(far.vertices.data(), {0.1, 0.2, 1}), 5.0F, 1e-5F);
  }
}

}  // namespace
}  // namespace wardslam::synth
