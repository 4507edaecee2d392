#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <opencv2/core.hpp>

#include "scene/scene.h"
#include "wardslam/core/camera_model.h"

namespace wardslam::synth {

/// What a camera without noise sees. All of the camera's size.
struct Rendering {
  cv::Mat color_bgr;    ///< CV_8UC3, anti-aliased.
  cv::Mat depth_m;      ///< CV_32FC1 along the optical axis, 0 = nothing there.
  cv::Mat instanceIds;  ///< CV_16UC1, Label::id.
};

/// Renders a scene by casting rays, through the camera's lens, each along the very way that light takes there. Any
/// number of threads may use one renderer at once.
class Renderer {
 public:
  /// Keeps a reference to the scene. Throws core::InputError where the lens cannot fill the image.
  Renderer(const Scene& scene, const core::CameraModel& camera);
  ~Renderer();

  [[nodiscard]] Rendering render(double t_s, const Eigen::Isometry3d& T_world_cam) const;
  /// Its colours alone.
  [[nodiscard]] cv::Mat renderColor(double t_s, const Eigen::Isometry3d& T_world_cam) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace wardslam::synth
