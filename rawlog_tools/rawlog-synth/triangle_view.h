#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "lens.h"
#include "mesh.h"

namespace wardslam::synth {

/// Flat triangles and whose they are, in the world frame. Their numbers are their places in the list.
class TriangleList {
 public:
  void add(const Mesh& mesh, std::uint16_t instanceId);
  /// Forgets all but the first `count`.
  void shrink(std::size_t count) { triangles_.resize(count); }
  [[nodiscard]] std::size_t size() const { return triangles_.size(); }

  struct View {
    cv::Mat depth_m;      ///< CV_32FC1
    cv::Mat instanceIds;  ///< CV_16UC1
  };

  /// Exact depth and instance of every pixel from the number of the triangle it shows (CV_32SC1, -1 = none): its ray is
  /// cut with the triangle's plane. (What MRPT makes of the depth buffer is off by
  /// millimetres.)
  [[nodiscard]] View lookedAt(const cv::Mat& triangleNumbers, const LensView& lens,
                              const Eigen::Isometry3d& T_world_cam) const;

 private:
  struct Triangle {
    std::array<Eigen::Vector3f, 3> corners_m;
    std::uint16_t instanceId = 0;
  };
  std::vector<Triangle> triangles_;
};

}  // namespace wardslam::synth
