#include "wardslam/evaluation/room_evaluation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace wardslam::evaluation {
namespace {

constexpr double kMost = 0.5;  // of a room, to be one with another, or a part of it

/// Crossings of a ray from the place.
bool contains(const std::vector<Eigen::Vector2d>& polygon_m, const Eigen::Vector2d& p_m) {
  bool isInside = false;
  for (std::size_t i = 0, j = polygon_m.size() - 1; i < polygon_m.size(); j = i++) {
    const Eigen::Vector2d& a = polygon_m[i];
    const Eigen::Vector2d& b = polygon_m[j];
    if ((a.y() > p_m.y()) == (b.y() > p_m.y())) continue;
    if (p_m.x() < a.x() + (p_m.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) isInside = !isInside;
  }
  return isInside;
}

/// Rooms that are open to each other are one, called by the first of them.
class Groups {
 public:
  Groups(const TrueBuilding& truth, double widestDoor_m) : truth_(truth) {
    for (std::size_t i = 0; i < truth.rooms.size(); ++i) {
      groupOf_.push_back(i);
      indexOf_[truth.rooms[i].id] = i;
    }
    for (const auto& door : truth.doors) {
      const auto room = groupOf(door.room);
      const auto other = groupOf(door.other);
      if (!door.hasLeaf && door.width_m() > widestDoor_m && room && other) unite(*room, *other);
    }
  }

  [[nodiscard]] std::optional<std::size_t> at(const Eigen::Vector2d& p_m) const {
    for (std::size_t i = 0; i < truth_.rooms.size(); ++i) {
      if (contains(truth_.rooms[i].polygon_m, p_m)) return groupOf_[i];
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<std::size_t> groupOf(const std::string& room) const {
    const auto index = indexOf_.find(room);
    return index == indexOf_.end() ? std::nullopt : std::optional(groupOf_[index->second]);
  }

  [[nodiscard]] std::string nameOf(std::size_t group) const {
    std::string names;
    for (std::size_t i = 0; i < groupOf_.size(); ++i) {
      if (groupOf_[i] == group) names += (names.empty() ? "" : ", ") + truth_.rooms[i].name;
    }
    return names;
  }

 private:
  void unite(std::size_t a, std::size_t b) {
    std::replace(groupOf_.begin(), groupOf_.end(), std::max(a, b), std::min(a, b));
  }

  const TrueBuilding& truth_;
  std::vector<std::size_t> groupOf_;
  std::map<std::string, std::size_t> indexOf_;
};

/// Cells of floor that the map knows.
struct Areas {
  std::map<std::size_t, std::size_t> seenOf;                    ///< By true room;
  std::map<int, std::size_t> sizeOf;                            ///< by room found;
  std::map<std::pair<std::size_t, int>, std::size_t> inCommon;  ///< by both.

  [[nodiscard]] std::size_t common(std::size_t room, int found) const {
    const auto cells = inCommon.find({room, found});
    return cells == inCommon.end() ? 0 : cells->second;
  }
};

Areas areasOf(const Groups& groups, const mapping::FloorPlan& plan, const building::Rooms& found,
              const Eigen::Isometry2d& T_truth_map) {
  Areas areas;
  for (int row = 0; row < plan.cells.rows; ++row) {
    for (int column = 0; column < plan.cells.cols; ++column) {
      const int id = found.ids.at<int>(row, column);
      if (id == 0 && plan.cells.at<unsigned char>(row, column) != mapping::FloorPlan::kFree) continue;
      if (id != 0) ++areas.sizeOf[id];
      const Eigen::Vector2d p_map_m = plan.origin_m + plan.resolution_m * Eigen::Vector2d(column + 0.5, row + 0.5);
      const auto room = groups.at(T_truth_map * p_map_m);
      if (!room) continue;
      ++areas.seenOf[*room];
      if (id != 0) ++areas.inCommon[{*room, id}];
    }
  }
  return areas;
}

/// With which room found it has most in common.
RoomEvaluation::Room judge(std::size_t room, const Areas& areas, const building::Rooms& found) {
  RoomEvaluation::Room judged;
  const auto seen = static_cast<double>(areas.seenOf.at(room));
  for (const auto& [id, size] : areas.sizeOf) {
    const auto common = static_cast<double>(areas.common(room, id));
    const double overlap = common / (seen + static_cast<double>(size) - common);
    if (overlap <= judged.overlap) continue;
    judged.overlap = overlap;
    judged.found = found.all.at(static_cast<std::size_t>(id - 1)).name;
  }
  return judged;
}

bool isMost(std::size_t part, std::size_t whole) {
  return static_cast<double>(part) >= kMost * static_cast<double>(whole);
}

void countSplitsAndJoins(const std::map<std::size_t, std::size_t>& rooms, const Areas& areas, RoomEvaluation& result) {
  std::map<int, std::size_t> roomsIn;
  for (const auto& [room, seen] : rooms) {
    std::size_t parts = 0;
    for (const auto& [id, size] : areas.sizeOf) {
      if (isMost(areas.common(room, id), size)) ++parts;
      if (isMost(areas.common(room, id), seen)) ++roomsIn[id];
    }
    if (parts > 1) result.splits += parts - 1;
  }
  for (const auto& [id, count] : roomsIn) {
    if (count > 1) result.joins += count - 1;
  }
}

/// The nearest first, one to one.
std::size_t matches(const std::vector<Eigen::Vector2d>& wanted_m, const std::vector<Eigen::Vector2d>& told_m,
                    double reach_m) {
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < wanted_m.size(); ++i) {
    for (std::size_t j = 0; j < told_m.size(); ++j) {
      const double away_m = (wanted_m[i] - told_m[j]).norm();
      if (away_m <= reach_m) pairs.emplace_back(away_m, i, j);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<bool> isMet(wanted_m.size());
  std::vector<bool> isUsed(told_m.size());
  std::size_t count = 0;
  for (const auto& [away_m, i, j] : pairs) {
    if (isMet[i] || isUsed[j]) continue;
    isMet[i] = isUsed[j] = true;
    ++count;
  }
  return count;
}

}  // namespace

double TrueBuilding::Door::free_m() const {
  if (!hasLeaf) return width_m();
  return std::min(width_m(), 2.0 * width_m() * std::sin(open_rad / 2.0));
}

double RoomEvaluation::meanOverlap() const {
  double sum = 0.0;
  for (const Room& room : rooms) sum += room.isFound ? room.overlap : 0.0;
  return found == 0 ? std::numeric_limits<double>::quiet_NaN() : sum / static_cast<double>(found);
}

RoomEvaluation evaluateRooms(const TrueBuilding& truth, const mapping::FloorPlan& plan, const building::Rooms& found,
                             const Eigen::Isometry2d& T_truth_map, const RoomEvaluationOptions& options) {
  const Groups groups(truth, options.widestDoor_m);
  const Areas areas = areasOf(groups, plan, found, T_truth_map);
  const double cell_m2 = plan.resolution_m * plan.resolution_m;
  RoomEvaluation result;
  std::map<std::size_t, std::size_t> counting;
  for (const auto& [room, cells] : areas.seenOf) {
    const double seen_m2 = static_cast<double>(cells) * cell_m2;
    if (seen_m2 < options.leastSeen_m2) continue;
    counting.emplace(room, cells);
    RoomEvaluation::Room& judged = result.rooms.emplace_back(judge(room, areas, found));
    judged.name = groups.nameOf(room);
    judged.seen_m2 = seen_m2;
    judged.isFound = judged.overlap > options.leastOverlap;
    if (judged.isFound) ++result.found;
  }
  result.told = found.all.size();
  countSplitsAndJoins(counting, areas, result);

  std::vector<Eigen::Vector2d> doors_m;
  for (const auto& door : truth.doors) {
    const auto room = groups.groupOf(door.room);
    const auto other = groups.groupOf(door.other);
    const bool isBetweenSeen = room && other && *room != *other && counting.count(*room) + counting.count(*other) == 2;
    if (isBetweenSeen && door.free_m() >= options.leastFree_m) doors_m.emplace_back((door.from_m + door.to_m) / 2.0);
  }
  std::vector<Eigen::Vector2d> told_m;
  for (const auto& door : found.doors) told_m.emplace_back(T_truth_map * door.middle_m());
  result.doors = doors_m.size();
  result.doorsTold = told_m.size();
  result.doorsFound = matches(doors_m, told_m, options.mostDoorError_m);
  return result;
}

}  // namespace wardslam::evaluation
