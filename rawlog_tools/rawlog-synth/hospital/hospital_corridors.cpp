#include <algorithm>
#include <cmath>

#include "hospital/hospital_rooms.h"
#include "scene/mesh.h"

namespace wardslam::synth {
namespace {

using Eigen::Isometry3f;

constexpr auto kPi = static_cast<float>(M_PI);
constexpr double kHalfWall_m = kInnerWall_m / 2.0;

/// Whether nothing is in this part of the corridor's wall: no door, no sign beside one, not the bare stretch.
bool isPlainWall(const HospitalPlan& plan, std::size_t corridor, double x_m, double y_m) {
  constexpr double kAside_m = 0.5;
  constexpr double kSign_m = 0.95;
  const WallStretch& bare = plan.bare;
  if (bare.room == corridor && x_m > bare.fromX_m - kAside_m && x_m < bare.toX_m + kAside_m) return false;
  return std::none_of(plan.doors.begin(), plan.doors.end(), [&](const Door& door) {
    if (door.corridor != corridor || std::abs(door.from_m.y() - y_m) > 0.1) return false;
    const auto [low, high] = std::minmax(door.from_m.x(), door.to_m.x());
    return x_m > low - kSign_m && x_m < high + kSign_m;
  });
}

/// One side of a long corridor: what hangs on its wall.
void hangAlong(Furnisher& f, std::size_t index, bool north) {
  const Room& room = f.plan().rooms[index];
  const double y = north ? room.area_m.max().y() : room.area_m.min().y();
  const auto inner = static_cast<float>(north ? y - kHalfWall_m : y + kHalfWall_m);
  for (double x = room.area_m.min().x() + 0.8; x < room.area_m.max().x() - 0.8; x += f.rng().uniform(1.3, 2.6)) {
    if (!isPlainWall(f.plan(), index, x, y)) continue;
    const Isometry3f wall =
        room.T_world_room.inverse() * at(static_cast<float>(x), inner, 0, north ? -kPi / 2 : kPi / 2);
    const int what = f.rng().uniform(0, 10);
    const float height_m = f.rng().uniform(1.6F, 1.8F);
    if (what == 0) {
      f.put(ItemKind::Extinguisher, index, wall);
    } else if (what == 1) {
      f.put(ItemKind::Dispenser, index, wall);
    } else if (what == 2) {
      f.put(ItemKind::Whiteboard, index, wall * at(0, 0, 1.65F));
    } else {
      f.put(ItemKind::Picture, index, wall * at(0, 0, height_m), {anyPoster(f), f.rng().uniform(0.42F, 0.68F)});
    }
  }
}

void addChairs(Furnisher& f, std::size_t index) {
  const Room& room = f.plan().rooms[index];
  for (double x = room.area_m.min().x() + 4.0; x < room.area_m.max().x() - 4.0; x += f.rng().uniform(4.5, 8.0)) {
    const bool north = f.rng().uniform(0, 2) == 1;
    const double y = north ? room.area_m.max().y() - 0.4 : room.area_m.min().y() + 0.4;
    const int chairs = f.rng().uniform(1, 4);
    for (int i = 0; i < chairs; ++i) {
      const Isometry3f place =
          at(static_cast<float>(x + 0.6 * i), static_cast<float>(y), 0, north ? -kPi / 2 : kPi / 2);
      f.put(ItemKind::Chair, index, room.T_world_room.inverse() * place);
    }
  }
}

void addHangingSigns(Furnisher& f, std::size_t index) {
  const HospitalPlan& plan = f.plan();
  const Isometry3f T_room_world = plan.rooms[index].T_world_room.inverse();
  const auto exitCell = static_cast<int>(plan.rooms.size());
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector2f p = junction(plan, index, i).cast<float>();
    const int cell = i == 0 ? exitCell : i == 1 ? exitCell + 1 : static_cast<int>(index);
    f.put(ItemKind::HangingSign, index, T_room_world * at(p.x() + (i == 2 ? -2.2F : 2.2F), p.y(), 0), {cell});
  }
}

}  // namespace

void furnishCorridor(Furnisher& f, std::size_t index) {
  const Room& room = f.plan().rooms[index];
  if (index != f.plan().corridorA && index != f.plan().corridorB) {  // a crossing
    if (f.rng().uniform(0, 2) == 0) f.putAtWall(ItemKind::Plant, index);
    f.putAtWall(ItemKind::Chair, index);
    return;
  }
  hangAlong(f, index, true);
  hangAlong(f, index, false);
  addHangingSigns(f, index);
  addChairs(f, index);
  const auto add = [&](ItemKind kind, int count) {
    for (int i = 0; i < count; ++i) f.putAtWall(kind, index);
  };
  add(ItemKind::Bed, 2);
  add(ItemKind::Trolley, 3);
  add(ItemKind::Wheelchair, 3);
  add(ItemKind::IvStand, 2);
  add(ItemKind::Plant, 4);
  add(ItemKind::TrashBin, 3);
  add(ItemKind::Cabinet, 1);
  for (const bool east : {false, true}) {  // daylight at both ends
    const auto x = static_cast<float>(east ? room.area_m.max().x() - kHalfWall_m : room.area_m.min().x() + kHalfWall_m);
    const auto y = static_cast<float>(room.area_m.center().y());
    f.put(ItemKind::Window, index, room.T_world_room.inverse() * at(x, y, 0.9F, east ? kPi : 0.0F),
          {f.rng().uniform(0, 8), 1.8F});
  }
}

}  // namespace wardslam::synth
