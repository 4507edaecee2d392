#include "wardslam/mapping/zone.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <opencv2/imgproc.hpp>

namespace wardslam::mapping {
namespace {

constexpr std::array<const char*, 6> kTypes = {"place", "forbidden", "slow", "one_way", "action", "release"};

std::vector<cv::Point2f> contourOf(const Zone& zone) {
  std::vector<cv::Point2f> contour;
  for (const auto& corner : zone.polygon_m) {
    contour.emplace_back(static_cast<float>(corner.x()), static_cast<float>(corner.y()));
  }
  return contour;
}

}  // namespace

std::string toString(ZoneType type) { return kTypes.at(static_cast<std::size_t>(type)); }

std::optional<ZoneType> zoneTypeFrom(const std::string& name) {
  const auto* const found = std::find(kTypes.begin(), kTypes.end(), name);
  if (found == kTypes.end()) return std::nullopt;
  return static_cast<ZoneType>(found - kTypes.begin());
}

std::vector<Zone> zonesOfType(const std::vector<Zone>& zones, ZoneType type) {
  std::vector<Zone> some;
  std::copy_if(zones.begin(), zones.end(), std::back_inserter(some),
               [type](const Zone& zone) { return zone.type == type; });
  return some;
}

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
