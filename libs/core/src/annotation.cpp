#include "wardslam/core/annotation.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <opencv2/core.hpp>

namespace wardslam::core {
namespace {

using Labels = mrpt::obs::TPixelLabelInfo<1>;

const Labels::TMapLabelID2Name& names() {
  static const Labels::TMapLabelID2Name kNames = {{static_cast<std::uint32_t>(PixelLabel::Dynamic), "dynamic"},
                                                  {static_cast<std::uint32_t>(PixelLabel::Movable), "movable"},
                                                  {static_cast<std::uint32_t>(PixelLabel::Person), "person"},
                                                  {static_cast<std::uint32_t>(PixelLabel::Thing), "thing"}};
  return kNames;
}

}  // namespace

void annotate(mrpt::obs::CObservation3DRangeScan& observation, const cv::Mat& labelBits) {
  auto labels = std::make_shared<Labels>();
  labels->setSize(labelBits.rows, labelBits.cols);
  labels->pixelLabelNames = names();
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

cv::Mat annotationOf(const mrpt::obs::CObservation3DRangeScan& observation) {
  const auto labels = std::dynamic_pointer_cast<const Labels>(observation.pixelLabels);
  if (!labels) return {};
  cv::Mat labelBits(static_cast<int>(labels->pixelLabels.rows()), static_cast<int>(labels->pixelLabels.cols()),
                    CV_8UC1);
  for (int row = 0; row < labelBits.rows; ++row) {
    auto* bits = labelBits.ptr<std::uint8_t>(row);
    for (int col = 0; col < labelBits.cols; ++col) bits[col] = labels->pixelLabels(row, col);
  }
  return labelBits;
}

void removeAnnotation(mrpt::obs::CObservation3DRangeScan& observation) {
  if (!observation.pixelLabels || observation.pixelLabels->pixelLabelNames != names()) return;
  observation.pixelLabels.reset();
  observation.hasConfidenceImage = false;
  observation.confidenceImage = {};
}

}  // namespace wardslam::core
