#include "triangle_view.h"

#include <gtest/gtest.h>

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

TEST(TriangleView, CutsRaysWithASlantedPlane) {
  const core::CameraModel camera;
  const Eigen::Vector3d n(0.2, -0.3, 1.0);
  TriangleList list;
  list.add(planeInFrontOf(somePose(), n, 4.0), 700);
  const auto view = list.lookedAt(cv::Mat(480, 640, CV_32SC1, cv::Scalar(0)), camera, somePose());
  for (const cv::Point pixel : {cv::Point(0, 0), cv::Point(639, 0), cv::Point(100, 470), cv::Point(320, 240)}) {
    const Eigen::Vector3d ray = camera.unproject(Eigen::Vector2d(pixel.x, pixel.y), 1.0);
    EXPECT_NEAR(view.depth_m.at<float>(pixel), 4.0 / n.dot(ray), 1e-4);
    EXPECT_EQ(view.instanceIds.at<std::uint16_t>(pixel), 700);
  }
}

TEST(TriangleView, KeepsToTheTriangleSeenEdgeOn) {
  const core::CameraModel camera;
  Mesh mesh;  // in the plane x = 0.001, which the rays of the middle column hardly meet
  for (const Eigen::Vector3f& p :
       {Eigen::Vector3f(0.001F, -1, 2), Eigen::Vector3f(0.001F, 1, 2), Eigen::Vector3f(0.001F, 0, 3)}) {
    mesh.vertices.push_back({p, Eigen::Vector3f::UnitX(), Eigen::Vector2f::Zero()});
  }
  TriangleList list;
  list.add(mesh, 1);
  const auto view = list.lookedAt(cv::Mat(480, 640, CV_32SC1, cv::Scalar(0)), camera, Eigen::Isometry3d::Identity());
  for (const int x : {300, 319, 320, 321, 400}) {
    EXPECT_GE(view.depth_m.at<float>(240, x), 2.0F);
    EXPECT_LE(view.depth_m.at<float>(240, x), 3.0F);
  }
}

TEST(TriangleView, NothingWhereNoTriangleIsShown) {
  TriangleList list;
  list.add(planeInFrontOf(somePose(), {0, 0, 1}, 2.0), 5);
  cv::Mat numbers(480, 640, CV_32SC1, cv::Scalar(-1));
  numbers.at<int>(10, 10) = 0;
  numbers.at<int>(20, 20) = 1;  // no such triangle
  const auto view = list.lookedAt(numbers, {}, somePose());
  EXPECT_EQ(cv::countNonZero(view.depth_m), 1);
  EXPECT_EQ(cv::countNonZero(view.instanceIds), 1);
}

TEST(TriangleView, ForgetsWhatIsShrunkAway) {
  TriangleList list;
  list.add(box({1, 1, 1}), 1);
  const std::size_t size = list.size();
  list.add(box({1, 1, 1}), 2);
  list.shrink(size);
  EXPECT_EQ(list.size(), 12U);
}

}  // namespace
}  // namespace wardslam::synth
