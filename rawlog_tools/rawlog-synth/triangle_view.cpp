#include "triangle_view.h"

#include <algorithm>
#include <cmath>

namespace wardslam::synth {
namespace {

/// Plane of a triangle in the camera frame, normal * p = offset, and the range of depths within it.
struct Plane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double offset = 0.0;
  double nearest_m = 0.0;
  double farthest_m = 0.0;
};

Plane planeThrough(const std::array<Eigen::Vector3f, 3>& corners_m, const Eigen::Isometry3d& T_cam_world) {
  std::array<Eigen::Vector3d, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = T_cam_world * corners_m[i].cast<double>();
  const auto [nearest, farthest] = std::minmax({p[0].z(), p[1].z(), p[2].z()});
  const Eigen::Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]);
  return {normal, normal.dot(p[0]), nearest, farthest};
}

/// Seen nearly edge-on, a ray may miss the triangle by a hair and its plane by miles: keep to the triangle.
double depthAlong(const Eigen::Vector3d& ray, const Plane& plane) {
  const double slant = plane.normal.dot(ray);
  const double depth = slant == 0.0 ? plane.nearest_m : plane.offset / slant;
  return std::clamp(depth, plane.nearest_m, plane.farthest_m);
}

}  // namespace

void TriangleList::add(const Mesh& mesh, std::uint16_t instanceId) {
  for (std::size_t i = 0; i + 2 < mesh.vertices.size(); i += 3) {
    triangles_.push_back({{mesh.vertices[i].p_m, mesh.vertices[i + 1].p_m, mesh.vertices[i + 2].p_m}, instanceId});
  }
}

TriangleList::View TriangleList::lookedAt(const cv::Mat& triangleNumbers, const LensView& lens,
                                          const Eigen::Isometry3d& T_world_cam) const {
  const Eigen::Isometry3d T_cam_world = T_world_cam.inverse();
  View view{cv::Mat::zeros(triangleNumbers.size(), CV_32FC1), cv::Mat::zeros(triangleNumbers.size(), CV_16UC1)};
  cv::parallel_for_({0, triangleNumbers.rows}, [&](const cv::Range& rows) {
    int known = -1;  // neighbours mostly show the same triangle
    Plane plane;
    for (int y = rows.start; y < rows.end; ++y) {
      for (int x = 0; x < triangleNumbers.cols; ++x) {
        const int number = triangleNumbers.at<int>(y, x);
        if (number < 0 || number >= static_cast<int>(triangles_.size())) continue;
        const Triangle& triangle = triangles_[static_cast<std::size_t>(number)];
        if (number != known) plane = planeThrough(triangle.corners_m, T_cam_world);
        known = number;
        view.depth_m.at<float>(y, x) = static_cast<float>(depthAlong(lens.ray(x, y), plane));
        view.instanceIds.at<std::uint16_t>(y, x) = triangle.instanceId;
      }
    }
  });
  return view;
}

}  // namespace wardslam::synth
