#include "wardslam/building/rooms.h"

#include <algorithm>
#include <cmath>

#include "wardslam/core/errors.h"
#include "wardslam/core/nearest_name.h"

namespace wardslam::building {

const Room* Rooms::at(const Eigen::Vector2d& p_map_m, double reach_m) const {
  const Eigen::Vector2d cell = (p_map_m - origin_m) / resolution_m - Eigen::Vector2d::Constant(0.5);
  const double reach = reach_m / resolution_m;
  if (!(cell.cwiseAbs().maxCoeff() < 1e8)) return nullptr;
  const auto first = [&](double at) { return static_cast<int>(std::max(0.0, std::round(at - reach))); };
  const auto last = [&](double at, int count) {
    return static_cast<int>(std::min(count - 1.0, std::round(at + reach)));
  };
  int found = 0;
  double nearest = std::max(reach, std::sqrt(0.5));
  for (int row = first(cell.y()); row <= last(cell.y(), ids.rows); ++row) {
    for (int column = first(cell.x()); column <= last(cell.x(), ids.cols); ++column) {
      const double distance = std::hypot(column - cell.x(), row - cell.y());
      if (ids.at<int>(row, column) == 0 || distance > nearest) continue;
      found = ids.at<int>(row, column);
      nearest = distance;
    }
  }
  return found == 0 ? nullptr : &all[static_cast<std::size_t>(found - 1)];
}

std::string Rooms::nameAround(const Eigen::Vector3d& p_map_m) const {
  const auto* room = at(p_map_m.head<2>(), kRoomReach_m);
  return room == nullptr ? std::string() : room->name;
}

const Room& Rooms::named(const std::string& name) const {
  const auto room = std::find_if(all.begin(), all.end(), [&name](const Room& each) { return each.name == name; });
  if (room != all.end()) return *room;
  if (all.empty()) throw core::InputError("no rooms are found in the map's floor plan, so none called '" + name + "'");
  std::vector<std::string> names;
  for (const auto& each : all) names.push_back(each.name);
  throw core::InputError("no room is called '" + name + "'; did you mean '" + core::nearestName(name, names) + "'?");
}

}  // namespace wardslam::building
