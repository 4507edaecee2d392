#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace wardslam::change {

/// A place known to move, or known to rest.
struct Seed {
  cv::Point cell;
  bool moves = false;
  double handicap_m = 0.0;  ///< The less sure, the more way it gives to others.
};

/// Makes regions of single observations: a cell moves when, walking along surfaces, the nearest seed is a moving one
/// and not farther than `reach_m`. Jumps in depth cannot be crossed; cells without depth can, as if at the depth one
/// came from, at twice the length.
/// `depth_m`: CV_32FC1, one value per cell, 0 = none. `cellWidth`: width of a cell at 1 m (m): its size in px / f.
/// Returns CV_8UC1, 255 where it moves.
[[nodiscard]] cv::Mat growRegions(const cv::Mat& depth_m, double cellWidth, const std::vector<Seed>& seeds,
                                  double reach_m);

}  // namespace wardslam::change
