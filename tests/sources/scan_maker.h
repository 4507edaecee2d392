#pragma once

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <opencv2/core.hpp>

#include "wardslam/core/camera_model.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::test {

/// A scan of 8x6 pixels, stamped 1000 s + `number`: random colours, 1000 + row * 8 + column + `number` millimetres.
inline mrpt::obs::CObservation3DRangeScan::Ptr makeScan(int number = 0, int width_px = 8, int height_px = 6) {
  core::CameraModel camera;
  camera.width_px = width_px;
  camera.height_px = height_px;
  camera.fx_px = camera.fy_px = 8.0;
  camera.cx_px = 3.5;
  camera.cy_px = 2.5;

  auto scan = mrpt::obs::CObservation3DRangeScan::Create();
  scan->timestamp = core::toMrptTime(1000.0 + number);
  scan->sensorLabel = "CAMERA";
  scan->cameraParams = scan->cameraParamsIntensity = core::toMrpt(camera);

  cv::Mat image(height_px, width_px, CV_8UC3);
  cv::RNG(static_cast<std::uint64_t>(number) + 1).fill(image, cv::RNG::UNIFORM, 0, 256);
  scan->hasIntensityImage = true;
  scan->intensityImage = mrpt::img::CImage(image, mrpt::img::DEEP_COPY);

  scan->hasRangeImage = true;
  scan->rangeUnits = 0.001F;
  scan->rangeImage_setSize(height_px, width_px);
  for (int row = 0; row < height_px; ++row) {
    for (int column = 0; column < width_px; ++column) {
      scan->rangeImage(row, column) = static_cast<std::uint16_t>(1000 + row * 8 + column + number);
    }
  }
  return scan;
}

}  // namespace wardslam::test
