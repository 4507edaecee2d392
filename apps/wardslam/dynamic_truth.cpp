#include "dynamic_truth.h"

#include <opencv2/imgcodecs.hpp>

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

/// 255 where the filters say that something moves; nowhere where they say nothing.
cv::Mat markedDynamic(const core::Frame& frame) {
  const cv::Mat dynamic = core::dynamicPixels(frame);
  return dynamic.empty() ? cv::Mat::zeros(frame.gray.size(), CV_8UC1) : dynamic;
}

bool isSet(const cv::Mat& mask, const cv::Point2f& raw_px) {
  return mask.at<std::uint8_t>(core::nearestPixel(raw_px, mask.size())) != 0;
}

}  // namespace

DynamicTruth::DynamicTruth(const std::filesystem::path& folder, double rate_hz)
    : folder_(folder), files_(folder, ".png", rate_hz) {}

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
