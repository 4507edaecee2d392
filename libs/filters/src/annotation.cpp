#include "wardslam/filters/annotation.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include "wardslam/core/annotation.h"

namespace wardslam::filters {

void annotateObservation(core::Frame& frame) {
  if (!frame.observation || frame.labelBits.empty()) return;
  const auto& range = frame.observation->rangeImage;
  if (range.rows() != frame.labelBits.rows || range.cols() != frame.labelBits.cols) {
    ++frame.events["filters.annotation_size"];
    return;
  }
  core::annotate(*frame.observation, frame.labelBits);
}

}  // namespace wardslam::filters
