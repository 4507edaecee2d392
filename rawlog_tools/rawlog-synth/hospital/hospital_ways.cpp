#include "hospital/hospital_ways.h"

#include <algorithm>
#include <cmath>

#include "hospital/hospital_drives.h"

namespace wardslam::synth {
namespace {

using Eigen::Vector2d;

class GraphBuilder {
 public:
  void addLine(const Polyline& line) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) addEdge(line[i], line[i + 1]);
  }
  [[nodiscard]] WayGraph take() { return std::move(graph_); }

 private:
  std::size_t nodeAt(const Vector2d& p_m) {
    constexpr double kSame_m = 0.05;
    for (std::size_t i = 0; i < graph_.nodes_m.size(); ++i) {
      if ((graph_.nodes_m[i] - p_m).norm() < kSame_m) return i;
    }
    graph_.nodes_m.push_back(p_m);
    return graph_.nodes_m.size() - 1;
  }
  void addEdge(const Vector2d& from_m, const Vector2d& to_m) {
    const std::size_t from = nodeAt(from_m);
    const std::size_t to = nodeAt(to_m);
    if (from == to) return;
    const std::pair<std::size_t, std::size_t> ends(std::min(from, to), std::max(from, to));
    if (std::find(graph_.edges.begin(), graph_.edges.end(), ends) == graph_.edges.end()) graph_.edges.push_back(ends);
  }

  WayGraph graph_;
};

bool canEnter(const HospitalPlan& plan, const Door& door) {
  return plan.rooms[door.room].kind != RoomKind::Corridor &&
         (door.state == DoorState::Open || door.state == DoorState::Passage);
}

std::size_t nearestNode(const WayGraph& graph, const Vector2d& p_m) {
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < graph.nodes_m.size(); ++i) {
    if ((graph.nodes_m[i] - p_m).norm() < (graph.nodes_m[nearest] - p_m).norm()) nearest = i;
  }
  return nearest;
}

/// All places of a corridor where one may turn off, from west to east.
Polyline corridorLine(const HospitalPlan& plan, std::size_t corridor) {
  Polyline line;
  for (std::size_t i = 0; i < 3; ++i) line.push_back(junction(plan, corridor, i));
  for (const Door& door : plan.doors) {
    if (door.corridor == corridor && canEnter(plan, door)) line.push_back(frontOf(plan, door));
  }
  std::sort(line.begin(), line.end(), [](const Vector2d& a, const Vector2d& b) { return a.x() < b.x(); });
  return line;
}

bool isClearSpot(const HospitalPlan& plan, const std::vector<Item>& items, const std::vector<Polyline>& drives,
                 const Vector2d& p_m) {
  constexpr double kFromThings_m = 0.35;
  constexpr double kFromDrives_m = 0.8;
  constexpr double kFromWalls_m = 0.4;
  const std::size_t room = plan.roomAt(p_m);
  if (room >= plan.rooms.size()) return false;
  const Eigen::AlignedBox2d& area = plan.rooms[room].area_m;
  const Vector2d margin = (p_m - area.min()).cwiseMin(area.max() - p_m);
  if (margin.minCoeff() < kFromWalls_m) return false;
  const auto tooNear = [&](const Item& item) { return distanceTo(item, p_m) < kFromThings_m; };
  if (std::any_of(items.begin(), items.end(), tooNear)) return false;
  return std::all_of(drives.begin(), drives.end(),
                     [&](const Polyline& drive) { return distanceTo(drive, p_m) > kFromDrives_m; });
}

}  // namespace

WayGraph wayGraph(const HospitalPlan& plan) {
  GraphBuilder builder;
  for (const std::size_t corridor : {plan.corridorA, plan.corridorB}) builder.addLine(corridorLine(plan, corridor));
  for (std::size_t i = 0; i < 3; ++i)
    builder.addLine({junction(plan, plan.corridorA, i), junction(plan, plan.corridorB, i)});
  for (const Door& door : plan.doors) {
    if (!canEnter(plan, door)) continue;
    if (isVisited(plan, door)) {
      Polyline visit = visitTo(plan, door);
      builder.addLine({visit[0], visit[1]});
      builder.addLine(Polyline(visit.begin() + 1, visit.end() - 1));
    } else {
      builder.addLine(doorstep(plan, door));
    }
  }
  return builder.take();
}

std::vector<Seat> seatsOf(const std::vector<Item>& items, const WayGraph& graph) {
  std::vector<Seat> seats;
  for (const Item& item : items) {
    if (item.kind != ItemKind::Chair) continue;
    const Vector2d p = item.T_world_item.translation().head<2>().cast<double>();
    const Eigen::Vector3f front = item.T_world_item.linear().col(0);
    seats.push_back({p, std::atan2(front.y(), front.x()), 0.495, nearestNode(graph, p)});
  }
  return seats;
}

std::vector<StandingSpot> standingSpots(const HospitalPlan& plan, const std::vector<Item>& items,
                                        const WayGraph& graph) {
  constexpr double kStep_m = 1.2;
  constexpr double kApart_m = 0.9;
  const std::vector<Polyline> drives = allDrives(plan);
  std::vector<StandingSpot> spots;
  for (const auto& [a, b] : graph.edges) {
    const Vector2d way = graph.nodes_m[b] - graph.nodes_m[a];
    const Vector2d along = way.normalized();
    const Vector2d aside(-along.y(), along.x());
    for (double s = kStep_m / 2; s < way.norm(); s += kStep_m) {
      for (const double side : {-1.1, 1.1}) {
        const Vector2d p = graph.nodes_m[a] + s * along + side * aside;
        const auto near = [&](const StandingSpot& spot) { return (spot.p_m - p).norm() < kApart_m; };
        if (std::any_of(spots.begin(), spots.end(), near) || !isClearSpot(plan, items, drives, p)) continue;
        const Vector2d facing = -side * aside;
        spots.push_back({p, std::atan2(facing.y(), facing.x()), nearestNode(graph, p)});
      }
    }
  }
  return spots;
}

}  // namespace wardslam::synth
