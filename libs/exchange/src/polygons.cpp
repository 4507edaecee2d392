#include "polygons.h"

#include <algorithm>

namespace wardslam::exchange {

std::vector<Eigen::Vector2d> closedRing(std::vector<Eigen::Vector2d> corners_m) {
  double twiceArea = 0.0;
  for (std::size_t i = 0; i < corners_m.size(); ++i) {
    const auto& a = corners_m[i];
    const auto& b = corners_m[(i + 1) % corners_m.size()];
    twiceArea += a.x() * b.y() - a.y() * b.x();
  }
  if (twiceArea < 0) std::reverse(corners_m.begin(), corners_m.end());
  if (!corners_m.empty()) corners_m.push_back(Eigen::Vector2d(corners_m.front()));
  return corners_m;
}

std::vector<Eigen::Vector2d> footprintOf(const mapping::MapObject& object) {
  const Eigen::Vector2d min = object.box_m.min().head<2>();
  const Eigen::Vector2d max = object.box_m.max().head<2>();
  return {min, {max.x(), min.y()}, max, {min.x(), max.y()}};
}

}  // namespace wardslam::exchange
