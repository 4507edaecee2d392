#include "wardslam/core/annotation.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <opencv2/core.hpp>

namespace wardslam::core {

void annotate(mrpt::obs::CObservation3DRangeScan& observation, const cv::Mat& labelBits) {
  using Labels = mrpt::obs::TPixelLabelInfo<1>;
  auto labels = std::make_shared<Labels>();
  labels->setSize(labelBits.rows, labelBits.cols);
  labels->pixelLabelNames = {{static_cast<std::uint32_t>(PixelLabel::Dynamic), "dynamic"},
                             {static_cast<std::uint32_t>(PixelLabel::Movable), "movable"},
                             {static_cast<std::uint32_t>(PixelLabel::Person), "person"},
                             {static_cast<std::uint32_t>(PixelLabel::Thing), "thing"}};
  for (int row = 0; row < labelBits.rows; ++row) {
    const auto* bits = labelBits.ptr<std::uint8_t>(row);
    for (int col = 0; col < labelBits.cols; ++col) labels->pixelLabels(row, col) = bits[col];
  }
  observation.pixelLabels = labels;

  cv::Mat isStatic;
  cv::bitwise_and(labelBits, cv::Scalar(bitOf(PixelLabel::Dynamic)), isStatic);
  cv::compare(isStatic, cv::Scalar(0), isStatic, cv::CMP_EQ);
  observation.confidenceImage = mrpt::img::CImage(isStatic, mrpt::img::DEEP_COPY);
  observation.hasConfidenceImage = true;
}

}  // namespace wardslam::core
