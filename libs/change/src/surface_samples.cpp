#include "wardslam/change/surface_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wardslam::change {

std::vector<Eigen::Vector3d> sampleSurface(const core::Frame& frame, const cv::Rect& box_px, int most,
                                           const std::function<bool(int, int)>& isIn) {
  const cv::Rect box = box_px & cv::Rect({}, frame.depth_m.size());
  const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(box.area()) / most))));
  std::vector<cv::Point2f> raw_px;
  std::vector<float> depths_m;
  for (int y = box.y + step / 2; y < box.br().y; y += step) {
    for (int x = box.x + step / 2; x < box.br().x; x += step) {
      const float depth_m = frame.depth_m.at<float>(y, x);
      if (depth_m <= 0 || !isIn(y, x)) continue;
      raw_px.emplace_back(static_cast<float>(x), static_cast<float>(y));
      depths_m.push_back(depth_m);
    }
  }
  const auto undistorted_px = raw_px.empty() ? raw_px : frame.camera.undistort(raw_px);
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < depths_m.size(); ++i) {
    const Eigen::Vector2d px = Eigen::Vector2f(undistorted_px[i].x, undistorted_px[i].y).cast<double>();
    points.push_back(frame.camera.unproject(px, static_cast<double>(depths_m[i])));
  }
  return points;
}

double gapBetween(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b) {
  double squared = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& p : a) {
    for (const Eigen::Vector3d& q : b) squared = std::min(squared, (p - q).squaredNorm());
  }
  return std::sqrt(squared);
}

}  // namespace wardslam::change
