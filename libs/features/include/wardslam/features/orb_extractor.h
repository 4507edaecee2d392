#pragma once

#include <opencv2/core.hpp>

#include "wardslam/core/camera_model.h"
#include "wardslam/core/frame.h"
#include "wardslam/core/keypoint.h"

namespace wardslam::features {

struct OrbOptions {
  int key_points = 1500;
  double scale_factor = 1.2;
  int levels = 8;
  int fast_threshold = 10;
  int oversampling = 4;
  int cell_size_px = 32;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("key_points", self.key_points, {50, 20000}, "count", "ORB key points per image");
    visit("scale_factor", self.scale_factor, {1.05, 2.0}, "", "between neighbouring levels of the image pyramid");
    visit("levels", self.levels, {1, 12}, "count", "levels of the image pyramid");
    visit("fast_threshold", self.fast_threshold, {1, 100}, "grey levels", "contrast a FAST corner must have");
    visit("oversampling", self.oversampling, {1, 20}, "", "candidates found per key point kept");
    visit("cell_size_px", self.cell_size_px, {8, 512}, "px", "cells that take turns when key points are chosen");
  }
};

/// Finds ORB key points spread evenly over the image, with orientation (Eq. 3–5) and depth.
class OrbExtractor {
 public:
  explicit OrbExtractor(const OrbOptions& options);

  /// `gray`: CV_8UC1, raw image. `depth_m`: CV_32FC1 of the same size, 0 = none; empty: none anywhere. Key points come
  /// finest level first.
  [[nodiscard]] core::Features extract(const cv::Mat& gray, const cv::Mat& depth_m,
                                       const core::CameraModel& camera) const;

  /// Fills Frame::features.
  void extract(core::Frame& frame) const { frame.features = extract(frame.gray, frame.depth_m, frame.camera); }

 private:
  OrbOptions options_;
};

}  // namespace wardslam::features
