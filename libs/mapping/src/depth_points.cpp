#include "wardslam/mapping/depth_points.h"

#include <cmath>

namespace wardslam::mapping {

std::vector<DepthPoint> depthPoints(const cv::Mat& depth_m, const core::CameraModel& camera, int step_px) {
  std::vector<cv::Point2f> raw_px;
  for (int y = 0; y < depth_m.rows; y += step_px) {
    for (int x = 0; x < depth_m.cols; x += step_px) {
      const float z_m = depth_m.at<float>(y, x);
      if (z_m > 0.0F && std::isfinite(z_m)) raw_px.emplace_back(static_cast<float>(x), static_cast<float>(y));
    }
  }
  const auto undistorted_px = camera.undistort(raw_px);
  std::vector<DepthPoint> points;
  points.reserve(raw_px.size());
  for (std::size_t i = 0; i < raw_px.size(); ++i) {
    const cv::Point pixel(raw_px[i]);
    const auto z_m = static_cast<double>(depth_m.at<float>(pixel));
    points.push_back({pixel, camera.unproject({undistorted_px[i].x, undistorted_px[i].y}, z_m)});
  }
  return points;
}

}  // namespace wardslam::mapping
