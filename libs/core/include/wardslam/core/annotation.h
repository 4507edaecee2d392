#pragma once

#include "wardslam/core/pixel_label.h"

namespace mrpt::obs {
class CObservation3DRangeScan;
}
namespace cv {
class Mat;
}

namespace wardslam::core {

/// Marks the observation so that stock MRPT programs can see what was filtered: one bit per PixelLabel in
/// `pixelLabels`, and `confidenceImage` = 0 where dynamic, 255 elsewhere.
/// `labelBits`: CV_8UC1 of the size of the range image, bit i = PixelLabel i. Replaces earlier annotations.
void annotate(mrpt::obs::CObservation3DRangeScan& observation, const cv::Mat& labelBits);

/// What annotate() wrote; empty where the observation has no such labels.
[[nodiscard]] cv::Mat annotationOf(const mrpt::obs::CObservation3DRangeScan& observation);

/// Takes away what annotate() wrote, in an earlier run say; annotations of others stay.
void removeAnnotation(mrpt::obs::CObservation3DRangeScan& observation);

}  // namespace wardslam::core
