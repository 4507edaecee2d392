#include "wardslam/mapping/zone.h"

#include <algorithm>
#include <limits>
#include <opencv2/imgproc.hpp>

namespace wardslam::mapping {
namespace {

std::vector<cv::Point2f> contourOf(const Zone& zone) {
  std::vector<cv::Point2f> contour;
  for (const auto& corner : zone.polygon_m) {
    contour.emplace_back(static_cast<float>(corner.x()), static_cast<float>(corner.y()));
  }
  return contour;
}

}  // namespace

bool contains(const Zone& zone, const Eigen::Vector2d& p_map_m) {
  const cv::Point2f p(static_cast<float>(p_map_m.x()), static_cast<float>(p_map_m.y()));
  return !zone.polygon_m.empty() && cv::pointPolygonTest(contourOf(zone), p, false) >= 0.0;
}

double distance_m(const Zone& zone, const Eigen::Vector2d& p_map_m) {
  if (zone.polygon_m.empty()) return std::numeric_limits<double>::infinity();
  const cv::Point2f p(static_cast<float>(p_map_m.x()), static_cast<float>(p_map_m.y()));
  return std::max(0.0, -cv::pointPolygonTest(contourOf(zone), p, true));
}

double area_m2(const Zone& zone) { return zone.polygon_m.empty() ? 0.0 : cv::contourArea(contourOf(zone)); }

}  // namespace wardslam::mapping
