#include "hospital/hospital_placing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/mesh.h"

namespace wardslam::synth {
namespace {

using Eigen::Isometry3f;
using Eigen::Vector2d;

constexpr int kTries = 60;
constexpr double kHalfWall_m = kInnerWall_m / 2.0;

Eigen::AlignedBox2d boundsOf(const Item& item) {
  Eigen::AlignedBox2d bounds;
  const Eigen::Isometry3d T = item.T_world_item.cast<double>();
  for (const auto corner : {Eigen::AlignedBox2d::BottomLeft, Eigen::AlignedBox2d::BottomRight,
                            Eigen::AlignedBox2d::TopLeft, Eigen::AlignedBox2d::TopRight}) {
    const Vector2d p = item.footprint_m.corner(corner);
    bounds.extend(Vector2d((T * Eigen::Vector3d(p.x(), p.y(), 0)).head<2>()));
  }
  return bounds;
}

/// Points of a line, close enough to each other.
template <typename Function>
bool anyAlong(const Polyline& line, Function&& isHit) {
  constexpr double kStep_m = 0.05;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vector2d way = line[i + 1] - line[i];
    const int steps = std::max(1, static_cast<int>(std::ceil(way.norm() / kStep_m)));
    for (int k = 0; k <= steps; ++k) {
      if (isHit(Vector2d(line[i] + way * k / steps))) return true;
    }
  }
  return false;
}

/// The four walls of a room, each as a frame on the floor at its inner face, x into the room, and half its length.
struct Wall {
  Isometry3f T;
  float half_m;
};

std::array<Wall, 4> wallsOf(const Room& room) {
  const auto low = (room.area_m.min().array() + kHalfWall_m).cast<float>();
  const auto high = (room.area_m.max().array() - kHalfWall_m).cast<float>();
  const Eigen::Vector2f middle = room.area_m.center().cast<float>();
  const Eigen::Vector2f half = (high - low) / 2;
  constexpr auto kPi = static_cast<float>(M_PI);
  return {{{at(middle.x(), high.y(), 0, -kPi / 2), half.x()},
           {at(middle.x(), low.y(), 0, kPi / 2), half.x()},
           {at(low.x(), middle.y(), 0, 0), half.y()},
           {at(high.x(), middle.y(), 0, kPi), half.y()}}};
}

}  // namespace

Placing::Placing(const HospitalPlan& plan) : plan_(plan), drives_(allDrives(plan)) {}

bool Placing::sparesDoors(const Item& item) const {
  if (item.kind == ItemKind::DoorLeaf) return true;
  constexpr double kReach_m = 3.0;  // of all that belongs to a door
  const Eigen::AlignedBox2d bounds = boundsOf(item);
  for (const Door& door : plan_.doors) {
    if (bounds.exteriorDistance(door.middle_m()) > kReach_m) continue;
    // A leaf needs its place on one side; on the other somebody may stand in front of it.
    const Room& room = plan_.rooms[door.room];
    const Vector2d into = (room.area_m.center() - door.middle_m()).y() > 0 ? Vector2d(0, 1) : Vector2d(0, -1);
    const double width_m = (door.to_m - door.from_m).norm();
    const bool hit = anyAlong({door.from_m, door.to_m}, [&](const Vector2d& p) {
      const double inside_m = door.state == DoorState::Passage ? 0.7 : width_m + 0.1;
      return anyAlong({p - 0.7 * into, p + inside_m * into},
                      [&](const Vector2d& q) { return distanceTo(item, q) < 0.04; });
    });
    if (hit) return false;
  }
  return true;
}

bool Placing::isClear(const Item& item) const {
  if (item.footprint_m.isEmpty() || item.kind == ItemKind::DoorLeaf) return true;
  const Eigen::AlignedBox2d bounds = boundsOf(item);
  Eigen::AlignedBox2d inside = plan_.rooms[item.room].area_m;
  inside.min().array() += kHalfWall_m - 0.01;
  inside.max().array() -= kHalfWall_m - 0.01;
  if (!inside.contains(bounds)) return false;
  const WallStretch& bare = plan_.bare;
  const bool inBare = item.room == bare.room && bounds.max().x() > bare.fromX_m && bounds.min().x() < bare.toX_m;
  if (inBare) return false;
  Eigen::AlignedBox2d wide = bounds;
  wide.min().array() -= kDriveClearance_m;
  wide.max().array() += kDriveClearance_m;
  for (const Polyline& drive : drives_) {
    const bool hit =
        anyAlong(drive, [&](const Vector2d& p) { return wide.contains(p) && distanceTo(item, p) < kDriveClearance_m; });
    if (hit) return false;
  }
  return sparesDoors(item);
}

bool Placing::isFree(const Item& item, const std::vector<Item>& others) const {
  const bool collides = std::any_of(others.begin(), others.end(), [&](const Item& other) {
    return other.identity != item.identity && other.room == item.room && collide(item, other, kGap_m);
  });
  return !collides && isClear(item);
}

std::optional<Isometry3f> Placing::atWall(Item item, std::size_t room, const std::vector<Item>& others,
                                          cv::RNG& rng) const {
  item.room = room;
  const auto walls = wallsOf(plan_.rooms[room]);
  const Vector2d size = item.footprint_m.sizes();
  const bool sideways = size.x() > 1.3 * size.y();
  for (int i = 0; i < kTries; ++i) {
    const Wall& wall = walls[static_cast<std::size_t>(rng.uniform(0, 4))];
    const float along_m = rng.uniform(-wall.half_m, wall.half_m);
    const float turned = sideways ? static_cast<float>(M_PI) / 2 * (rng.uniform(0, 2) == 0 ? 1.0F : -1.0F) : 0.0F;
    const Isometry3f turn = at(0, 0, 0, turned + rng.uniform(-0.06F, 0.06F));
    // As near to the wall as its turned footprint allows, and a little off it.
    item.T_world_item = turn;
    const auto depth_m = static_cast<float>(-boundsOf(item).min().x());
    item.T_world_item = wall.T * at(depth_m + rng.uniform(0.03F, 0.1F), along_m, 0) * turn;
    if (isFree(item, others)) return item.T_world_item;
  }
  return std::nullopt;
}

std::optional<Isometry3f> Placing::anywhere(Item item, std::size_t room, const std::vector<Item>& others,
                                            cv::RNG& rng) const {
  item.room = room;
  const Eigen::AlignedBox2d& area = plan_.rooms[room].area_m;
  for (int i = 0; i < kTries; ++i) {
    const double x = rng.uniform(area.min().x(), area.max().x());
    const double y = rng.uniform(area.min().y(), area.max().y());
    item.T_world_item = at(static_cast<float>(x), static_cast<float>(y), 0, rng.uniform(-3.14F, 3.14F));
    if (isFree(item, others)) return item.T_world_item;
  }
  return std::nullopt;
}

}  // namespace wardslam::synth
