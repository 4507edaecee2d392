#pragma once

#include <opencv2/core.hpp>

#include "wardslam/core/event_counts.h"
#include "wardslam/core/label_space.h"
#include "wardslam/core/segmentation.h"

namespace wardslam::segmentation {

/// Tells what an image shows. Plain and single-threaded; AsyncSegmenter runs one in its own thread.
class Segmenter {
 public:
  struct Result {
    core::Segmentation segmentation;  ///< Empty when this image could not be segmented.
    core::EventCounts events;         ///< Why, by name.
  };

  virtual ~Segmenter() = default;

  /// `color_bgr`: CV_8UC3, raw. `stamp_s`: UNIX time of the image. Throws core::InputError only for what no later
  /// image can mend (a masks folder that belongs to another recording).
  [[nodiscard]] virtual Result segment(const cv::Mat& color_bgr, double stamp_s) = 0;

  /// After the last image. Throws core::InputError when the run as a whole shows that the set-up was wrong (not one
  /// image found its mask).
  virtual void finish() {}

  /// Names of the class ids it puts out.
  [[nodiscard]] virtual const core::LabelSpace& labelSpace() const = 0;
};

}  // namespace wardslam::segmentation
