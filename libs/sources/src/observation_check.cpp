#include "observation_check.h"

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationStereoImages.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include "wardslam/core/camera_limits.h"

namespace wardslam::sources {
namespace {

using mrpt::img::TCamera;

constexpr double kLeastBaseline_m = 0.001;
constexpr double kFarthest_m = 1e8;

constexpr const char* kGiveCamera = "give the right --camera";
constexpr const char* kCorrectRawlog = "correct that with rawlog-edit --camera-params";

std::string sizeText(std::size_t width_px, std::size_t height_px) {
  return std::to_string(width_px) + "x" + std::to_string(height_px);
}

/// What reckons with other numbers takes for ever, or ends nowhere.
bool isPossible(const TCamera& camera) {
  const auto isFocus = [](double focus_px) { return focus_px >= 1.0 && focus_px <= core::kLongestFocus_px; };
  const bool isLens =
      std::all_of(camera.dist.begin(), camera.dist.end(), [](double k) { return std::abs(k) <= core::kStrongestLens; });
  return isFocus(camera.fx()) && isFocus(camera.fy()) && isLens;
}

bool isPossible(const mrpt::poses::CPose3D& pose) {
  const auto angles = {pose.yaw(), pose.pitch(), pose.roll()};
  return std::all_of(angles.begin(), angles.end(), [](double angle_rad) { return std::isfinite(angle_rad); }) &&
         std::abs(pose.x()) <= kFarthest_m && std::abs(pose.y()) <= kFarthest_m && std::abs(pose.z()) <= kFarthest_m;
}

/// `remedy`: what to do about a wrong calibration.
std::optional<std::string> whyUnusable(const TCamera& camera, std::size_t width_px, std::size_t height_px,
                                       const std::string& name, const std::string& remedy) {
  if (!(camera.fx() > 0.0 && camera.fy() > 0.0)) return "has no calibration of its " + name + " camera; " + remedy;
  if (!isPossible(camera)) return "has a calibration of its " + name + " camera that no camera has; " + remedy;
  if (camera.distortion == mrpt::img::DistortionModel::kannala_brandt) {
    return "has a fisheye " + name + " camera; rectify the images and " + remedy;
  }
  if (camera.ncols != width_px || camera.nrows != height_px) {
    return "has a " + name + " image of " + sizeText(width_px, height_px) + " pixels, but its camera has " +
           sizeText(camera.ncols, camera.nrows) + "; " + remedy;
  }
  const bool isCentreInside = camera.cx() >= -0.5 && camera.cx() <= static_cast<double>(width_px) - 0.5 &&
                              camera.cy() >= -0.5 && camera.cy() <= static_cast<double>(height_px) - 0.5;
  if (!isCentreInside) {
    return "has a " + name + " camera whose principal point lies outside its image of " +
           sizeText(width_px, height_px) + " pixels; " + remedy;
  }
  return std::nullopt;
}

bool isEightBit(const cv::Mat& image) { return image.type() == CV_8UC1 || image.type() == CV_8UC3; }

}  // namespace

std::optional<std::string> whyUnusable(const mrpt::obs::CObservation3DRangeScan& observation) {
  if (!observation.hasIntensityImage || observation.intensityImage.isEmpty()) return "has no intensity image";
  if (!observation.hasRangeImage || observation.rangeImage.size() == 0) return "has no range image";
  if (observation.timestamp == INVALID_TIMESTAMP) return "has no time stamp";
  if (!(std::isfinite(observation.rangeUnits) && observation.rangeUnits > 0.0F)) return "has no valid range unit";

  if (!isPossible(observation.sensorPose) || !isPossible(observation.relativePoseIntensityWRTDepth)) {
    return "has a pose of its camera that is none";
  }

  const cv::Mat& image = observation.intensityImage.asCvMatRef();
  if (!isEightBit(image)) return "has an intensity image that is not 8 bit grey or RGB";
  auto reason = whyUnusable(observation.cameraParamsIntensity, static_cast<std::size_t>(image.cols),
                            static_cast<std::size_t>(image.rows), "colour", kGiveCamera);
  if (reason) return reason;
  return whyUnusable(observation.cameraParams, static_cast<std::size_t>(observation.rangeImage.cols()),
                     static_cast<std::size_t>(observation.rangeImage.rows()), "depth", kGiveCamera);
}

std::optional<std::string> whyUnusable(const mrpt::obs::CObservationStereoImages& pair) {
  if (pair.imageLeft.isEmpty()) return "has no left image";
  if (!pair.hasImageRight || pair.imageRight.isEmpty()) return "has no right image";
  if (pair.timestamp == INVALID_TIMESTAMP) return "has no time stamp";
  const cv::Mat& left = pair.imageLeft.asCvMatRef();
  const cv::Mat& right = pair.imageRight.asCvMatRef();
  if (!isEightBit(left) || !isEightBit(right)) return "has an image that is not 8 bit grey or RGB";
  const auto width_px = static_cast<std::size_t>(left.cols);
  const auto height_px = static_cast<std::size_t>(left.rows);
  if (left.size() != right.size()) {
    return "has a left image of " + sizeText(width_px, height_px) + " pixels and a right one of " +
           sizeText(static_cast<std::size_t>(right.cols), static_cast<std::size_t>(right.rows)) +
           "; record both in the same size";
  }
  if (auto reason = whyUnusable(pair.leftCamera, width_px, height_px, "left", kCorrectRawlog)) return reason;
  if (auto reason = whyUnusable(pair.rightCamera, width_px, height_px, "right", kCorrectRawlog)) return reason;
  if (!(pair.rightCameraPose.norm() > kLeastBaseline_m)) {
    return std::string("has both cameras in one place; ") + kCorrectRawlog;
  }
  if (!(pair.rightCameraPose.norm() < core::kLongestBaseline_m)) {
    return std::string("has its cameras farther apart than any stereo camera; ") + kCorrectRawlog;
  }
  return std::nullopt;
}

}  // namespace wardslam::sources
