#pragma once

#include <opencv2/core.hpp>

#include "wardslam/core/camera_model.h"
#include "wardslam/core/event_counts.h"
#include "wardslam/core/label_space.h"
#include "wardslam/core/segmentation.h"

namespace wardslam::core {
struct Frame;
}

namespace wardslam::segmentation {

/// What a segmenter is shown of a frame. Images share memory with it and are only read.
struct SegmenterInput {
  cv::Mat color_bgr;     ///< CV_8UC3, raw.
  double stamp_s = 0.0;  ///< UNIX time of the image.
  cv::Mat depth_m = {};  ///< CV_32FC1 of the size of the colour image and registered to it, 0 = none; may be empty.
  core::CameraModel camera = {};  ///< Of both.
};

[[nodiscard]] SegmenterInput inputOf(const core::Frame& frame);

/// Tells what an image shows. Plain and single-threaded; AsyncSegmenter runs one in its own thread.
class Segmenter {
 public:
  struct Result {
    core::Segmentation segmentation;  ///< Empty when this image could not be segmented.
    core::EventCounts events;         ///< Why, by name.
  };

  virtual ~Segmenter() = default;

  /// Masks of the size of the colour image. Throws core::InputError only for what no later image can mend (a masks
  /// folder that belongs to another recording).
  [[nodiscard]] virtual Result segment(const SegmenterInput& input) = 0;

  /// After the last image. Throws core::InputError when the run as a whole shows that the set-up was wrong (not one
  /// image found its mask).
  virtual void finish() {}

  /// Names of the class ids it puts out.
  [[nodiscard]] virtual const core::LabelSpace& labelSpace() const = 0;
};

}  // namespace wardslam::segmentation
