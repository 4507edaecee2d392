#include "wardslam/segmentation/segmenter.h"

#include "wardslam/core/frame.h"

namespace wardslam::segmentation {

SegmenterInput inputOf(const core::Frame& frame) {
  return {frame.color_bgr, frame.stamp_s, frame.depth_m, frame.camera};
}

}  // namespace wardslam::segmentation
