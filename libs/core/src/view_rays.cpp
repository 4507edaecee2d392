#include "wardslam/core/view_rays.h"

#include <vector>

namespace wardslam::core {

cv::Mat viewRays(const CameraModel& camera) {
  cv::Mat rays(camera.height_px, camera.width_px, CV_32FC2);
  std::vector<cv::Point2f> row_px(static_cast<std::size_t>(camera.width_px));
  for (int v = 0; v < rays.rows; ++v) {
    for (int u = 0; u < rays.cols; ++u) {
      row_px[static_cast<std::size_t>(u)] = {static_cast<float>(u), static_cast<float>(v)};
    }
    const std::vector<cv::Point2f> undistorted_px = camera.undistort(row_px);
    auto* ray = rays.ptr<cv::Vec2f>(v);
    for (const cv::Point2f& pixel : undistorted_px) {
      *ray++ = {static_cast<float>((pixel.x - camera.cx_px) / camera.fx_px),
                static_cast<float>((pixel.y - camera.cy_px) / camera.fy_px)};
    }
  }
  return rays;
}

}  // namespace wardslam::core
