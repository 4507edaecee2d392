#include "judge.h"

#include <algorithm>
#include <utility>

namespace wardslam::nav_demo {
namespace {

constexpr double kEncounter_m = 1.0;

/// Counts how often something begins.
template <class Flag>
void note(bool now, Flag&& before, int& count) {
  if (now && !before) ++count;
  before = now;
}

}  // namespace

Judge::Judge(const TrueWorld& world, std::vector<mapping::Zone> forbidden, const Eigen::Isometry2d& T_world_map,
             double radius_m)
    : world_(world), forbidden_(std::move(forbidden)), T_map_world_(T_world_map.inverse()), radius_m_(radius_m) {}

void Judge::look(const Eigen::Vector2d& robot_world_m, const std::vector<Disc>& people) {
  if (hasLast_) verdict_.way_m += (robot_world_m - last_m_).norm();
  last_m_ = robot_world_m;
  hasLast_ = true;

  const double toThing_m = world_.roomAt_m(robot_world_m) - radius_m_;
  verdict_.nearestThing_m = std::min(verdict_.nearestThing_m, toThing_m);
  note(toThing_m <= 0.0, touchesThing_, verdict_.contactsWithThings);

  touchesPerson_.resize(people.size());
  isNearPerson_.resize(people.size());
  for (std::size_t i = 0; i < people.size(); ++i) {
    const double gap_m = (people[i].p_m - robot_world_m).norm() - people[i].radius_m - radius_m_;
    verdict_.nearestPerson_m = std::min(verdict_.nearestPerson_m, gap_m);
    note(gap_m <= 0.0, touchesPerson_[i], verdict_.contactsWithPeople);
    note(gap_m <= kEncounter_m, isNearPerson_[i], verdict_.encounters);
  }

  const Eigen::Vector2d robot_map_m = T_map_world_ * robot_world_m;
  const bool isInZone = std::any_of(forbidden_.begin(), forbidden_.end(), [&](const auto& zone) {
    return mapping::distance_m(zone, robot_map_m) <= radius_m_;
  });
  note(isInZone, isInZone_, verdict_.zonesEntered);
}

}  // namespace wardslam::nav_demo
