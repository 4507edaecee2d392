#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

#include "wardslam/core/segmentation.h"

namespace wardslam::segmentation {

/// The box in whole pixels, cut off at the border of the image; empty where nothing of it is inside.
[[nodiscard]] cv::Rect roundedWithin(const cv::Rect2d& box_px, const cv::Size& image_px);

/// 255 in each of `size_px` pixels whose value exceeds the threshold. Values are interpolated linearly in `values`
/// (CV_32F), from which the nearest are taken beyond its border; pixel centre (x + 0.5, y + 0.5) lies at
/// scale * centre + offset there.
[[nodiscard]] cv::Mat thresholdResampled(const cv::Mat& values, const cv::Size& size_px, const cv::Point2d& scale,
                                         const cv::Point2d& offset, double threshold);

/// Puts instances together to a segmentation. They are to come by falling confidence: where they overlap, the first has
/// the pixel, and one left without any is dropped. Ids count from 1.
class InstancePainter {
 public:
  explicit InstancePainter(const cv::Size& image_px);

  /// `mask`: CV_8UC1 of the size of the box, which lies inside the image; changed.
  void paint(core::ClassId classId, float confidence, const cv::Rect& box_px, cv::Mat mask);

  [[nodiscard]] const core::Segmentation& segmentation() const { return segmentation_; }

 private:
  core::Segmentation segmentation_;
};

}  // namespace wardslam::segmentation
