#include "dynamic_truth.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <opencv2/imgcodecs.hpp>

#include "wardslam/core/annotation.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/nearest_pixel.h"

namespace wardslam::apps {
namespace {

cv::Mat readTruth(const std::filesystem::path& file, const cv::Size& size) {
  cv::Mat truth = cv::imread(file.string(), cv::IMREAD_GRAYSCALE);
  if (truth.empty()) throw core::InputError(file.string() + ": damaged or not a PNG; write what moves there anew");
  if (truth.size() != size) {
    throw core::InputError(file.string() + ": " + std::to_string(truth.cols) + "x" + std::to_string(truth.rows) +
                           " pixels, but the image it is about has " + std::to_string(size.width) + "x" +
                           std::to_string(size.height));
  }
  return truth;
}

/// 255 where the filters wrote "dynamic"; nowhere where they wrote nothing.
cv::Mat markedDynamic(const core::Frame& frame) {
  cv::Mat bits;
  if (frame.observation) bits = core::annotationOf(*frame.observation);
  if (bits.size() != frame.gray.size()) return cv::Mat::zeros(frame.gray.size(), CV_8UC1);
  cv::bitwise_and(bits, cv::Scalar(core::bitOf(core::PixelLabel::Dynamic)), bits);
  return bits;
}

bool isSet(const cv::Mat& mask, const cv::Point2f& raw_px) {
  return mask.at<std::uint8_t>(core::nearestPixel(raw_px, mask.size())) != 0;
}

}  // namespace

DynamicTruth::DynamicTruth(const std::filesystem::path& folder) : folder_(folder), files_(folder, ".png") {}

void DynamicTruth::onFrame(const core::Frame& frame, const odometry::OdometryResult& /*odometry*/) {
  constexpr double kTolerance_s = 0.005;
  const auto file = files_.nearest(frame.stamp_s, kTolerance_s);
  if (!file) return;
  const cv::Mat truth = readTruth(*file, frame.gray.size());
  ++frames_;
  pixels_ += evaluation::comparePixels(markedDynamic(frame), truth);
  for (const core::Keypoint& keypoint : frame.features.keypoints) {
    keypoints_.add(keypoint.motion == core::Motion::Dynamic, isSet(truth, keypoint.raw_px));
  }
}

}  // namespace wardslam::apps
