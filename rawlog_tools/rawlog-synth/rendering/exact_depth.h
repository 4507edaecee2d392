#pragma once

#include <Eigen/Geometry>

#include "scene/mesh.h"

namespace wardslam::synth {

/// Depths to the digit, where it is known which triangle a ray meets: the ray is cut with the triangle's plane in
/// double precision.
class ExactDepth {
 public:
  explicit ExactDepth(const Eigen::Isometry3d& T_world_cam) : T_cam_world_(T_world_cam.inverse()) {}

  /// Along the optical axis, in metres. `corners`: three, world frame; `ray`: camera frame, z = 1.
  [[nodiscard]] float of(const Vertex* corners, const Eigen::Vector3d& ray);

 private:
  /// normal * p = offset in the camera frame, and the range of depths within the triangle.
  struct Plane {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    double offset = 0.0;
    double nearest_m = 0.0;
    double farthest_m = 0.0;
  };
  [[nodiscard]] Plane planeThrough(const Vertex* corners) const;

  Eigen::Isometry3d T_cam_world_;
  const Vertex* known_ = nullptr;  ///< Neighbours mostly show the same triangle.
  Plane plane_;
};

}  // namespace wardslam::synth
