#include "life/society_world.h"

#include <algorithm>
#include <cmath>

namespace wardslam::synth {
namespace {

using Eigen::Vector2d;

Vector2d direction(double heading_rad) { return {std::cos(heading_rad), std::sin(heading_rad)}; }

constexpr double kOffTheRoute_m = 0.95;  ///< Who rests is passed by the camera at that distance.
constexpr double kNear_m = 3.5;

void add(SocietyWorld& world, RestingPlace place, double halfWidth_m) {
  if (world.cameraRoute.at(place.p_m) < kOffTheRoute_m) return;
  const std::size_t node = reachableNode(world, place.p_m, halfWidth_m);
  if (node == kNobody) return;
  place.wayNode = node;
  world.places.push_back(place);
}

void addSeats(SocietyWorld& world, const std::vector<Seat>& seats) {
  for (const Seat& seat : seats) {
    RestingPlace place{RestingPlace::Kind::Seat, seat.p_m + kSeatedFeet_m * direction(seat.heading_rad),
                       seat.heading_rad, seat.seat_m, seat.wayNode};
    if (world.cameraRoute.at(seat.p_m) >= 0.7) add(world, place, 0.06);
  }
}

/// Two to four who stand together, facing each other.
void addGroup(SocietyWorld& world, const Vector2d& middle_m, double turn_rad) {
  constexpr double kRadius_m = 0.5;
  for (int i = 0; i < 3; ++i) {
    const double angle = turn_rad + 2 * M_PI / 3 * i;
    const Vector2d p = middle_m + kRadius_m * direction(angle);
    if (world.walls.at(p) >= kBodyRadius_m) add(world, {RestingPlace::Kind::Group, p, angle + M_PI, 0.0, 0}, 0.2);
  }
}

/// Beside the middle of an edge, where that is wide enough.
void addBesides(SocietyWorld& world, const Vector2d& a_m, const Vector2d& b_m) {
  const Vector2d along = (b_m - a_m).normalized();
  const Vector2d left(-along.y(), along.x());
  for (double s = 0.8; s < (b_m - a_m).norm() - 0.6; s += 3.2) {
    const Vector2d middle = a_m + s * along;
    for (const double side : {-1.0, 1.0}) {
      double away = 0.0;  // as far to the side as there is room for a trolley
      while (away < 1.5 && world.walls.at(middle + side * (away + 0.1) * left) > 0.5) away += 0.1;
      const Vector2d p = middle + side * away * left;
      if (away < 0.3 || world.walls.at(p) < 0.45) continue;
      const double heading = std::atan2(along.y(), along.x()) + (side > 0 ? M_PI : 0.0);
      add(world, {RestingPlace::Kind::Parking, p, heading, 0.0, 0}, 0.4);
      if (away > 0.9) addGroup(world, p - side * 0.1 * left, heading);
    }
  }
}

}  // namespace

std::size_t reachableNode(const SocietyWorld& world, const Vector2d& p_m, double halfWidth_m) {
  const auto& nodes = world.ways.graph().nodes_m;
  std::size_t best = kNobody;
  double best_m = kNear_m;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double distance_m = (nodes[i] - p_m).norm();
    if (distance_m >= best_m || world.walls.along(nodes[i], p_m) < halfWidth_m) continue;
    best = i;
    best_m = distance_m;
  }
  return best;
}

void findPlaces(SocietyWorld& world, const Ways& ways) {
  addSeats(world, ways.seats);
  for (const StandingSpot& spot : ways.spots)
    add(world, {RestingPlace::Kind::Spot, spot.p_m, spot.heading_rad, 0.0, spot.wayNode}, 0.2);
  for (const auto& [a, b] : ways.graph.edges) addBesides(world, ways.graph.nodes_m[a], ways.graph.nodes_m[b]);
}

void measureWays(SocietyWorld& world) {
  std::vector<double> halfWidths_m;
  const WayGraph& graph = world.ways.graph();
  for (const auto& [a, b] : graph.edges)
    halfWidths_m.push_back(std::max(kWayClearance_m, world.walls.along(graph.nodes_m[a], graph.nodes_m[b])));
  world.ways.setHalfWidths(std::move(halfWidths_m));
}

std::vector<Vector2d> pathBetween(const SocietyWorld& world, std::size_t from, std::size_t to, double halfWidth_m) {
  std::vector<Vector2d> path;
  for (const std::size_t node : world.ways.way(from, to, halfWidth_m)) path.push_back(world.ways.graph().nodes_m[node]);
  return path;
}

}  // namespace wardslam::synth
