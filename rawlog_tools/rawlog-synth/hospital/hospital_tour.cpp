#include "hospital/hospital_tour.h"

#include <algorithm>
#include <opencv2/core.hpp>

namespace wardslam::synth {
namespace {

using Eigen::Vector2d;

/// A place where a corridor and a crossing meet.
struct Node {
  bool onA;
  std::size_t crossing;
};
using Lap = std::vector<Node>;

// All laps begin at the west end of corridor A, eastwards, and come back to it from the north: any follows any.
const Lap kWhole = {{true, 0}, {true, 1}, {true, 2}, {false, 2}, {false, 1}, {false, 0}};
const Lap kWestHalf = {{true, 0}, {true, 1}, {false, 1}, {false, 0}};
const Lap kEight = {{true, 0}, {true, 1}, {false, 1}, {false, 2}, {true, 2}, {true, 1}, {false, 1}, {false, 0}};

double lengthOf(const Polyline& line) {
  double sum_m = 0.0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) sum_m += (line[i + 1] - line[i]).norm();
  return sum_m;
}

class Tour {
 public:
  Tour(const HospitalPlan& plan, std::uint64_t number) : plan_(plan), rng_(number) {}

  /// Calls at the given doors on the way, each once.
  void addLap(const Lap& lap, std::vector<std::size_t> doors);
  /// Laps until it is long enough.
  void addLaps();
  [[nodiscard]] std::vector<std::size_t> visitedDoors(bool wardsOnly) const;
  [[nodiscard]] Polyline take() { return std::move(corners_m_); }

 private:
  void addLeg(const Node& from, const Node& to, std::vector<std::size_t>& doors);

  const HospitalPlan& plan_;
  cv::RNG rng_;
  Polyline corners_m_;
};

std::vector<std::size_t> Tour::visitedDoors(bool wardsOnly) const {
  std::vector<std::size_t> doors;
  for (std::size_t i = 0; i < plan_.doors.size(); ++i) {
    const bool ward = plan_.rooms[plan_.doors[i].room].kind == RoomKind::Ward;
    if (isVisited(plan_, plan_.doors[i]) && (ward || !wardsOnly)) doors.push_back(i);
  }
  return doors;
}

void Tour::addLeg(const Node& from, const Node& to, std::vector<std::size_t>& doors) {
  const std::size_t corridor = from.onA ? plan_.corridorA : plan_.corridorB;
  const Vector2d begin = junction(plan_, corridor, from.crossing);
  const Vector2d end = junction(plan_, to.onA ? plan_.corridorA : plan_.corridorB, to.crossing);
  corners_m_.push_back(begin);
  if (from.onA != to.onA) return;  // through a crossing
  const double way = end.x() > begin.x() ? 1.0 : -1.0;
  std::vector<std::size_t> here;
  for (const std::size_t door : doors) {
    const double x = plan_.doors[door].middle_m().x();
    if (plan_.doors[door].corridor == corridor && (x - begin.x()) * way > 0 && (end.x() - x) * way > 0)
      here.push_back(door);
  }
  std::sort(here.begin(), here.end(), [&](std::size_t a, std::size_t b) {
    return plan_.doors[a].middle_m().x() * way < plan_.doors[b].middle_m().x() * way;
  });
  for (const std::size_t door : here) {
    const Polyline visit = visitTo(plan_, plan_.doors[door]);
    corners_m_.insert(corners_m_.end(), visit.begin(), visit.end());
    doors.erase(std::find(doors.begin(), doors.end(), door));
  }
}

void Tour::addLap(const Lap& lap, std::vector<std::size_t> doors) {
  for (std::size_t i = 0; i < lap.size(); ++i) addLeg(lap[i], lap[(i + 1) % lap.size()], doors);
}

void Tour::addLaps() {
  const std::vector<std::size_t> all = visitedDoors(false);
  std::vector<Lap> laps = {kWhole, kEight, kWestHalf};
  for (std::size_t round = 0; round < laps.size() || lengthOf(corners_m_) < kTourLength_m; ++round) {
    if (round % laps.size() == 0 && round > 0) laps = {kWhole, kEight};
    if (round == 0) std::swap(laps[0], laps[static_cast<std::size_t>(rng_.uniform(0, 2))]);
    std::vector<std::size_t> some;
    for (const std::size_t door : all) {
      if (rng_.uniform(0, 2) == 0) some.push_back(door);
    }
    addLap(laps[round % laps.size()], round == 0 ? all : some);
  }
}

/// Without corners that are none, or lie upon each other.
Polyline tidied(const Polyline& corners_m) {
  constexpr double kSame_m = 0.05;
  Polyline apart;
  for (const Vector2d& p : corners_m) {
    if (apart.empty() || (p - apart.back()).norm() > kSame_m) apart.push_back(p);
  }
  while (apart.size() > 1 && (apart.front() - apart.back()).norm() <= kSame_m) apart.pop_back();
  Polyline tidy;
  const std::size_t n = apart.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2d before = (apart[i] - apart[(i + n - 1) % n]).normalized();
    const Vector2d after = (apart[(i + 1) % n] - apart[i]).normalized();
    if (before.dot(after) < 0.9999) tidy.push_back(apart[i]);
  }
  return tidy;
}

const Room& roomOf(const HospitalPlan& plan, RoomKind kind) {
  return *std::find_if(plan.rooms.begin(), plan.rooms.end(), [&](const Room& room) { return room.kind == kind; });
}

Polyline roughCorners(const HospitalPlan& plan, const RouteChoice& choice, std::uint64_t number) {
  Tour tour(plan, number);
  switch (choice.kind) {
    case RouteKind::Tour:
      tour.addLaps();
      break;
    case RouteKind::Wards:
      tour.addLap(kWhole, tour.visitedDoors(true));
      break;
    case RouteKind::Round:
      tour.addLap(kWhole, {});
      break;
    case RouteKind::Corridor:
      return alongCorridor(plan);
    case RouteKind::Lobby:
      return roundIn(roomOf(plan, RoomKind::Lobby));
  }
  return tour.take();
}

/// Spread evenly over the storey, so that robots next to each other in number are not so in space.
Vector2d startOf(const HospitalPlan& plan, int robot) {
  const Vector2d steps = robot * Vector2d(0.7548776662, 0.5698402910) + Vector2d(0.5, 0.5);
  return (steps.array() - steps.array().floor()) * plan.size_m.array();
}

void beginNear(const Vector2d& p_m, Polyline& corners_m) {
  const auto isNearer = [&](const Vector2d& a, const Vector2d& b) { return (a - p_m).norm() < (b - p_m).norm(); };
  std::rotate(corners_m.begin(), std::min_element(corners_m.begin(), corners_m.end(), isNearer), corners_m.end());
}

}  // namespace

Polyline cornersOf(const HospitalPlan& plan, const RouteChoice& choice, std::uint32_t seed) {
  const auto robot = static_cast<std::uint64_t>(choice.robot);
  const std::uint64_t number = (static_cast<std::uint64_t>(seed) << 32U) + 40000 + robot;
  Polyline corners_m = tidied(roughCorners(plan, choice, number));
  if (choice.robot % 2 == 1) std::reverse(corners_m.begin(), corners_m.end());
  if (choice.robot > 0) beginNear(startOf(plan, choice.robot), corners_m);
  return corners_m;
}

}  // namespace wardslam::synth
