#include "hospital/hospital_drives.h"

#include <algorithm>
#include <limits>

namespace wardslam::synth {
namespace {

using Eigen::Vector2d;

Vector2d toWorld(const Room& room, double x_m, double y_m) {
  const Eigen::Vector3d p = room.T_world_room.cast<double>() * Eigen::Vector3d(x_m, y_m, 0);
  return p.head<2>();
}

/// How the round lies in the room, in its frame: half its width, its near and its far side.
struct Round {
  double half_m;
  double near_m;
  double far_m;
};

Round roundOf(const Room& room) {
  if (room.kind == RoomKind::Ward) return {0.95, 2.1, room.depth_m() - 2.1};
  const double aside_m = room.kind == RoomKind::Lobby ? 2.6 : 1.9;  // of the side walls; a reception needs its place
  return {room.width_m() / 2 - aside_m, 1.5, room.depth_m() - 1.5};
}

}  // namespace

Vector2d frontOf(const HospitalPlan& plan, const Door& door) {
  return {door.middle_m().x(), plan.rooms[door.corridor].area_m.center().y()};
}

bool isVisited(const HospitalPlan& plan, const Door& door) {
  const RoomKind kind = plan.rooms[door.room].kind;
  if (kind == RoomKind::Ward) return door.state == DoorState::Open;
  return kind == RoomKind::Lobby || kind == RoomKind::DayRoom;
}

Polyline roundIn(const Room& room) {
  const Round round = roundOf(room);
  return {toWorld(room, round.half_m, round.near_m), toWorld(room, round.half_m, round.far_m),
          toWorld(room, -round.half_m, round.far_m), toWorld(room, -round.half_m, round.near_m)};
}

Polyline visitTo(const HospitalPlan& plan, const Door& door) {
  const Room& room = plan.rooms[door.room];
  const Vector2d in = toWorld(room, 0.0, roundOf(room).near_m);
  Polyline way = {frontOf(plan, door), in};
  const Polyline round = roundIn(room);
  way.insert(way.end(), round.begin(), round.end());
  way.push_back(in);
  way.push_back(frontOf(plan, door));
  return way;
}

Polyline doorstep(const HospitalPlan& plan, const Door& door) {
  const double depth_m = plan.rooms[door.room].kind == RoomKind::NurseStation ? 0.5 : 1.2;  // its counter is there
  const Vector2d front = frontOf(plan, door);
  return {front, door.middle_m() + (door.middle_m() - front).normalized() * depth_m};
}

Vector2d junction(const HospitalPlan& plan, std::size_t corridor, std::size_t crossing) {
  return {plan.rooms[plan.crossings[crossing]].area_m.center().x(), plan.rooms[corridor].area_m.center().y()};
}

Polyline alongCorridor(const HospitalPlan& plan) {
  constexpr double kLoop_m = 1.5;
  const Vector2d west = junction(plan, plan.corridorA, 0);
  const Vector2d east = junction(plan, plan.corridorA, 2);
  const Vector2d half(kLoop_m / 2, 0);
  const Vector2d north(0, kLoop_m);
  // Out to the end wall, north, back, south, and off again.
  return {east + half, east + half + north, east - half + north, east - half,
          west - half, west - half + north, west + half + north, west + half};
}

std::vector<Polyline> allDrives(const HospitalPlan& plan) {
  std::vector<Polyline> drives;
  for (const std::size_t corridor : {plan.corridorA, plan.corridorB})
    drives.push_back({junction(plan, corridor, 0), junction(plan, corridor, 2)});
  for (std::size_t i = 0; i < 3; ++i)
    drives.push_back({junction(plan, plan.corridorA, i), junction(plan, plan.corridorB, i)});
  for (const Door& door : plan.doors) {
    const Room& room = plan.rooms[door.room];
    if (room.kind == RoomKind::Corridor) continue;
    if (room.kind == RoomKind::Ward || isVisited(plan, door)) {  // wards stay alike, whatever their doors are
      drives.push_back(visitTo(plan, door));
      Polyline round = roundIn(room);
      round.push_back(round.front());
      drives.push_back(round);
    } else {
      drives.push_back(doorstep(plan, door));
    }
  }
  drives.push_back(alongCorridor(plan));
  return drives;
}

double distanceTo(const Polyline& line, const Vector2d& p_m) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vector2d way = line[i + 1] - line[i];
    const double s = std::clamp(way.dot(p_m - line[i]) / std::max(way.squaredNorm(), 1e-12), 0.0, 1.0);
    nearest_m = std::min(nearest_m, (line[i] + s * way - p_m).norm());
  }
  return nearest_m;
}

}  // namespace wardslam::synth
