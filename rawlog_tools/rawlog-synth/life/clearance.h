#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <vector>

#include "scene/scene.h"

namespace wardslam::synth {

/// How far it is from anywhere on the floor to the nearest of some points or things, to about a cell.
class ClearanceMap {
 public:
  /// To what stands between shin and head height of somebody who walks, of the things whose `counts` is true (all where
  /// it is empty). Triangles of floor and ceiling do not count.
  ClearanceMap(const std::vector<Thing>& things, const std::vector<bool>& counts);
  /// To these points.
  explicit ClearanceMap(const std::vector<Eigen::Vector2d>& points_m);

  /// Within kFar_m of what counts; beyond, and where nothing counts, kFar_m.
  [[nodiscard]] double at(const Eigen::Vector2d& p_m) const;
  /// The least along a straight line.
  [[nodiscard]] double along(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m) const;

  static constexpr double kFar_m = 5.0;

 private:
  void open(const Eigen::AlignedBox2d& box_m);
  [[nodiscard]] cv::Point2d cell(const Eigen::Vector2d& p_m) const;
  void measure();

  cv::Mat distance_m_;  ///< CV_32FC1; while it is being filled CV_8UC1, 0 = taken.
  Eigen::Vector2d origin_m_ = Eigen::Vector2d::Zero();
};

}  // namespace wardslam::synth
