#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <vector>

#include "wardslam/mapping/view.h"

namespace wardslam::mapping {

/// What one view saw in one cell of the map: the mean of its pixels there.
struct Sample {
  Eigen::Vector3f p_map_m = Eigen::Vector3f::Zero();
  Eigen::Vector3f color_rgb = Eigen::Vector3f::Zero();  ///< 0..255
  float depth_m = 0.0F;                                 ///< From the view, along its optical axis.
  float sigma_m = 0.0F;                                 ///< Standard deviation of that depth.
  int pixels = 0;
  std::uint16_t instance = 0;  ///< Of the view's segmentation; what differs in it makes samples of its own.
};

/// A cell of a grid with its corner in the origin, as one number; unique within ± 2^20 cells.
[[nodiscard]] std::uint64_t cellOf(const Eigen::Vector3f& p_m, float side_m);

/// Gathers the usable pixels (CV_8UC1, not 0; every `pixel_step`-th of a row and of a column) of a view by cell.
/// `rays`: core::viewRays of its camera.
[[nodiscard]] std::vector<Sample> sampleView(const View& view, const Eigen::Isometry3d& T_map_cam, const cv::Mat& rays,
                                             const cv::Mat& usable, float cell_m, int pixel_step);

}  // namespace wardslam::mapping
