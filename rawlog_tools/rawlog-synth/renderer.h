#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <opencv2/core.hpp>

#include "scene.h"
#include "wardslam/core/camera_model.h"

namespace wardslam::synth {

/// What a camera without noise sees. All of the camera's size.
struct Rendering {
  cv::Mat color_bgr;    ///< CV_8UC3, anti-aliased.
  cv::Mat depth_m;      ///< CV_32FC1 along the optical axis, 0 = nothing there.
  cv::Mat instanceIds;  ///< CV_16UC1, Label::id.
};

/// Renders a scene without a display. Use each renderer in the thread that made it, and one renderer per thread.
class Renderer {
 public:
  /// Keeps a reference to the scene. A distorting lens is looked through (LensView). Throws core::InputError when the
  /// machine offers no OpenGL.
  Renderer(const Scene& scene, const core::CameraModel& camera);
  ~Renderer();

  [[nodiscard]] Rendering render(double t_s, const Eigen::Isometry3d& T_world_cam);
  /// Its colours alone.
  [[nodiscard]] cv::Mat renderColor(double t_s, const Eigen::Isometry3d& T_world_cam);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace wardslam::synth
