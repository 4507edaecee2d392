#include "observation_check.h"

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <cmath>
#include <opencv2/core.hpp>

namespace wardslam::sources {
namespace {

using mrpt::img::TCamera;

std::string sizeText(std::size_t width_px, std::size_t height_px) {
  return std::to_string(width_px) + "x" + std::to_string(height_px);
}

std::optional<std::string> whyUnusable(const TCamera& camera, std::size_t width_px, std::size_t height_px,
                                       const std::string& name) {
  if (!(camera.fx() > 0.0 && camera.fy() > 0.0)) return "has no calibration of its " + name + " camera; give --camera";
  if (camera.distortion == mrpt::img::DistortionModel::kannala_brandt) {
    return "has a fisheye " + name + " camera; rectify the images and give --camera";
  }
  if (camera.ncols != width_px || camera.nrows != height_px) {
    return "has a " + name + " image of " + sizeText(width_px, height_px) + " pixels, but its camera has " +
           sizeText(camera.ncols, camera.nrows) + "; give the right --camera";
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> whyUnusable(const mrpt::obs::CObservation3DRangeScan& observation) {
  if (!observation.hasIntensityImage || observation.intensityImage.isEmpty()) return "has no intensity image";
  if (!observation.hasRangeImage || observation.rangeImage.size() == 0) return "has no range image";
  if (observation.timestamp == INVALID_TIMESTAMP) return "has no time stamp";
  if (!(std::isfinite(observation.rangeUnits) && observation.rangeUnits > 0.0F)) return "has no valid range unit";

  const cv::Mat& image = observation.intensityImage.asCvMatRef();
  if (image.type() != CV_8UC1 && image.type() != CV_8UC3) return "has an intensity image that is not 8 bit grey or RGB";
  auto reason = whyUnusable(observation.cameraParamsIntensity, static_cast<std::size_t>(image.cols),
                            static_cast<std::size_t>(image.rows), "colour");
  if (reason) return reason;
  return whyUnusable(observation.cameraParams, static_cast<std::size_t>(observation.rangeImage.cols()),
                     static_cast<std::size_t>(observation.rangeImage.rows()), "depth");
}

}  // namespace wardslam::sources
