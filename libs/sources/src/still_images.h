#pragma once

#include "wardslam/core/frame.h"

namespace wardslam::sources {

/// Finds images that stand still although the camera goes on delivering: what a sensor measures is never twice the same
/// to the last bit. Depth that comes at a lower rate than colour is repeated for that, and soon known by it.
class StillImages {
 public:
  /// Repeats for longer are no lower rate.
  static constexpr double kLowestRate_s = 0.25;

  /// Counts "sources.image_repeated" (the colour image is that of the frame before), and "sources.depth_still" where
  /// depth is repeated more often than usual while colours go on; that depth says where things were, and is taken out
  /// of the frame.
  void look(core::Frame& frame);

 private:
  cv::Mat gray_;     ///< Of the frame before.
  cv::Mat depth_m_;  ///< The same, as it was measured.
  double depthSince_s_ = 0.0;
  int repeats_ = 0;  ///< Of that depth.
  int usual_ = 1;    ///< The most repeats that a lower rate explains.
};

}  // namespace wardslam::sources
