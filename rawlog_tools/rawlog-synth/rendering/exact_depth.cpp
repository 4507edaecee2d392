#include "rendering/exact_depth.h"

#include <algorithm>
#include <array>

namespace wardslam::synth {

ExactDepth::Plane ExactDepth::planeThrough(const Vertex* corners) const {
  std::array<Eigen::Vector3d, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = T_cam_world_ * corners[i].p_m.cast<double>();
  const auto [nearest, farthest] = std::minmax({p[0].z(), p[1].z(), p[2].z()});
  const Eigen::Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]);
  return {normal, normal.dot(p[0]), nearest, farthest};
}

float ExactDepth::of(const Vertex* corners, const Eigen::Vector3d& ray) {
  if (corners != known_) plane_ = planeThrough(corners);
  known_ = corners;
  const double slant = plane_.normal.dot(ray);
  const double depth_m = slant == 0.0 ? plane_.nearest_m : plane_.offset / slant;
  // Seen nearly edge-on, a ray may miss the triangle by a hair and its plane by miles: keep to the triangle.
  return static_cast<float>(std::clamp(depth_m, plane_.nearest_m, plane_.farthest_m));
}

}  // namespace wardslam::synth
