#include "hospital/hospital_sight.h"

#include <algorithm>
#include <utility>

namespace wardslam::synth {
namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Between two directions, less than half a turn apart; `right` first, counter-clockwise to `left`.
struct Cone {
  Vector2d right;
  Vector2d left;
};

class Sight {
 public:
  Sight(const HospitalPlan& plan, const Vector2d& p_m) : plan_(plan), p_m_(p_m), seen_(plan.rooms.size(), false) {}

  void enter(std::size_t room, const Cone* cone);
  [[nodiscard]] std::vector<bool> take() { return std::move(seen_); }

 private:
  const HospitalPlan& plan_;
  Vector2d p_m_;
  std::vector<bool> seen_;
  std::vector<std::size_t> path_;  ///< Rooms looked through.
};

void Sight::enter(std::size_t room, const Cone* cone) {
  constexpr double kOnIt_m = 0.4;  // so close to a door, its angle says little
  seen_[room] = true;
  path_.push_back(room);
  for (const Door& door : plan_.doors) {
    if (door.state == DoorState::Closed || (door.room != room && door.corridor != room)) continue;
    const std::size_t next = door.room == room ? door.corridor : door.room;
    if (std::find(path_.begin(), path_.end(), next) != path_.end()) continue;
    Cone through{door.from_m - p_m_, door.to_m - p_m_};
    if (cross(through.right, through.left) < 0) std::swap(through.right, through.left);
    const Vector2d along = (door.to_m - door.from_m).normalized();
    if (std::abs(cross(along, door.from_m - p_m_)) < kOnIt_m) {
      enter(next, cone);
      continue;
    }
    if (cone) {
      if (cross(cone->right, through.right) < 0) through.right = cone->right;
      if (cross(through.left, cone->left) < 0) through.left = cone->left;
      if (cross(through.right, through.left) <= 0) continue;
    }
    enter(next, &through);
  }
  path_.pop_back();
}

}  // namespace

std::vector<bool> roomsSeenFrom(const HospitalPlan& plan, const Vector2d& p_m) {
  const std::size_t here = plan.roomAt(p_m);
  if (here >= plan.rooms.size()) return std::vector<bool>(plan.rooms.size(), true);
  Sight sight(plan, p_m);
  sight.enter(here, nullptr);
  return sight.take();
}

std::size_t ownerOf(const Door& door) { return door.state == DoorState::Closed ? door.corridor : door.room; }

}  // namespace wardslam::synth
