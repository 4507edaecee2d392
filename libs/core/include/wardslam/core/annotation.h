#pragma once

#include <cstdint>

namespace mrpt::obs {
class CObservation3DRangeScan;
}
namespace cv {
class Mat;
}

namespace wardslam::core {

/// Meaning of the bits in CObservation3DRangeScan::pixelLabels, and their names there.
enum class PixelLabel : std::uint8_t { Dynamic = 0, Movable = 1, Person = 2, Thing = 3 };

/// Marks the observation so that stock MRPT programs can see what was filtered: one bit per PixelLabel in
/// `pixelLabels`, and `confidenceImage` = 0 where dynamic, 255 elsewhere.
/// `labelBits`: CV_8UC1 of the size of the range image, bit i = PixelLabel i. Replaces earlier annotations.
void annotate(mrpt::obs::CObservation3DRangeScan& observation, const cv::Mat& labelBits);

/// What annotate() wrote; empty where the observation has no such labels.
[[nodiscard]] cv::Mat annotationOf(const mrpt::obs::CObservation3DRangeScan& observation);

/// Takes away what annotate() wrote, in an earlier run say; annotations of others stay.
void removeAnnotation(mrpt::obs::CObservation3DRangeScan& observation);

[[nodiscard]] constexpr std::uint8_t bitOf(PixelLabel label) {
  return static_cast<std::uint8_t>(1U << static_cast<unsigned>(label));
}

}  // namespace wardslam::core
