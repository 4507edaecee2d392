#pragma once

#include <mrpt/obs/CObservation3DRangeScan.h>

#include "support/textured_room.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::test {

/// What the camera of TexturedRoom records on its walk, 32 images per second from 1000 s on.
inline mrpt::obs::CObservation3DRangeScan::Ptr observe(const TexturedRoom& room, int image) {
  const auto view = room.look(TexturedRoom::T_room_cam(image));
  auto scan = mrpt::obs::CObservation3DRangeScan::Create();
  scan->timestamp = core::toMrptTime(1000.0 + image / 32.0);
  scan->cameraParams = scan->cameraParamsIntensity = core::toMrpt(TexturedRoom::camera320x240());
  scan->hasIntensityImage = true;
  scan->intensityImage = mrpt::img::CImage(view.color_bgr, mrpt::img::DEEP_COPY);
  scan->hasRangeImage = true;
  scan->range_is_depth = true;
  scan->rangeUnits = 1.0F / 5000.0F;
  scan->rangeImage_setSize(view.depth_m.rows, view.depth_m.cols);
  view.depth_m.convertTo(cv::Mat(view.depth_m.size(), CV_16UC1, scan->rangeImage.data()), CV_16U, 5000.0);
  return scan;
}

}  // namespace wardslam::test
