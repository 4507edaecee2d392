#include "hospital/hospital_rooms.h"

#include <algorithm>
#include <cmath>

#include "furniture/hospital_furniture.h"
#include "hospital/hospital_sight.h"
#include "scene/mesh.h"

namespace wardslam::synth {
namespace {

using Eigen::Isometry3f;
using Eigen::Vector3f;

constexpr auto kPi = static_cast<float>(M_PI);
constexpr float kHalfWall_m = kInnerWall_m / 2;

/// The walls of a room, seen in its frame: on the floor at the wall, x into the room.
Isometry3f westWall(const Room& room, float y_m) { return at(-room.width_m() / 2 + kHalfWall_m, y_m, 0, 0); }
Isometry3f eastWall(const Room& room, float y_m) { return at(room.width_m() / 2 - kHalfWall_m, y_m, 0, kPi); }
Isometry3f farWall(const Room& room, float x_m) { return at(x_m, room.depth_m() - kHalfWall_m, 0, -kPi / 2); }
Isometry3f nearWall(float x_m) { return at(x_m, kHalfWall_m, 0, kPi / 2); }

void addBedPlace(Furnisher& f, std::size_t room, int slot, const Isometry3f& wall, bool occupied) {
  constexpr float kGap_m = 0.12F;
  const Isometry3f head = wall * at(kGap_m, 0, 0);
  f.put(ItemKind::Bed, room, head * at(f.rng().uniform(0.0F, 0.05F), 0, 0, f.rng().uniform(-0.03F, 0.03F)),
        {12 + slot % 3, 1.0F, occupied});
  f.putNudged(ItemKind::Cabinet, room, head * at(0.28F, 0.88F, 0));
  if (slot % 2 == 0) f.putNudged(ItemKind::IvStand, room, head * at(0.5F, -0.96F, 0));
  f.putNudged(ItemKind::Chair, room, head * at(1.35F, -0.95F, 0, 1.3F));
  f.put(ItemKind::Outlets, room, wall * at(0, 0, 1.45F));
  f.put(ItemKind::Monitor, room, wall * at(0, 0.42F, 1.85F));
  f.put(ItemKind::Picture, room, wall * at(0, -0.25F, 1.95F), {4 + slot, 0.3F});
}

void hang(Furnisher& f, std::size_t room, const Isometry3f& wall) {
  const int poster = anyPoster(f);
  const float width_m = f.rng().uniform(0.45F, 0.65F);
  f.put(ItemKind::Picture, room, wall * at(0, 0, f.rng().uniform(1.6F, 1.8F)), {poster, width_m});
}

void putAlongWalls(Furnisher& f, std::size_t room, ItemKind kind, int count) {
  for (int i = 0; i < count; ++i) f.putAtWall(kind, room);
}

/// A table with chairs around it.
void addTable(Furnisher& f, std::size_t room, const Isometry3f& place, int chairs) {
  if (!f.putNudged(ItemKind::Table, room, place)) return;
  for (int i = 0; i < chairs; ++i) {
    const float angle = kPi / 2 * static_cast<float>(i) + f.rng().uniform(-0.2F, 0.2F);
    f.put(ItemKind::Chair, room, place * at(0, 0, 0, angle) * at(-0.8F, 0, 0));
  }
}

/// Chairs beside each other, their fronts along x of `middle`.
void addRow(Furnisher& f, std::size_t room, const Isometry3f& middle, int chairs) {
  for (int i = 0; i < chairs; ++i) {
    const float y = 0.63F * (static_cast<float>(i) - static_cast<float>(chairs - 1) / 2);
    f.put(ItemKind::Chair, room, middle * at(0, y, 0, f.rng().uniform(-0.05F, 0.05F)));
  }
}

}  // namespace

void furnishWard(Furnisher& f, std::size_t index, bool patients) {
  const Room& room = f.plan().rooms[index];
  const float ys[] = {2.15F, room.depth_m() - 1.55F};
  for (int slot = 0; slot < 4; ++slot) {
    const float y = ys[slot / 2];
    addBedPlace(f, index, slot, slot % 2 == 0 ? westWall(room, y) : eastWall(room, y), patients && slot % 3 == 0);
  }
  const float middle = (ys[0] + ys[1]) / 2;
  f.put(ItemKind::Curtain, index, westWall(room, middle) * at(0.1F, 0, 0), {0, f.rng().uniform(1.0F, 1.5F)});
  f.put(ItemKind::Curtain, index, eastWall(room, middle) * at(0.1F, 0, 0), {0, f.rng().uniform(1.0F, 1.5F)});
  addTable(f, index, at(0, room.depth_m() - 0.7F, 0), 0);
  f.put(ItemKind::Chair, index, at(-0.95F, room.depth_m() - 0.6F, 0, 0.1F));
  f.put(ItemKind::Chair, index, at(0.95F, room.depth_m() - 0.65F, 0, kPi - 0.2F));
  f.put(ItemKind::Basin, index, nearWall(2.0F));
  f.put(ItemKind::TrashBin, index, nearWall(-1.2F) * at(0.28F, 0, 0));
  f.put(ItemKind::Wheelchair, index, at(-2.45F, 0.44F, 0, f.rng().uniform(-0.04F, 0.04F)));
  f.putNudged(ItemKind::Trolley, index, at(3.1F, 0.5F, 0, kPi));
  f.put(ItemKind::Screen, index, at(-2.35F, room.depth_m() - 0.5F, 0, kPi / 2));
  f.put(ItemKind::Television, index, nearWall(-2.6F) * at(0, 0, 1.85F));
  hang(f, index, nearWall(2.9F));
  hang(f, index, farWall(room, -2.9F));
  hang(f, index, farWall(room, 2.9F));
}

void furnishLobby(Furnisher& f, std::size_t index) {
  const Room& room = f.plan().rooms[index];
  const float d = room.depth_m();
  f.put(ItemKind::Counter, index, westWall(room, d / 2) * at(1.7F, 0, 0), {0, 2.6F});
  for (const float side : {-1.0F, 1.0F}) {  // back to back in the middle
    addRow(f, index, at(0, d / 2 + side * 0.35F, 0, side * kPi / 2), 4);
    addRow(f, index, nearWall(side * (room.width_m() / 2 - 2.2F)) * at(0.36F, 0, 0), 3);
  }
  for (const float y : {0.7F, d - 0.7F}) f.put(ItemKind::Plant, index, eastWall(room, y) * at(0.6F, 0, 0));
  f.put(ItemKind::Plant, index, westWall(room, d - 0.65F) * at(0.55F, 0, 0));
  addRow(f, index, farWall(room, room.width_m() / 2 - 2.6F) * at(0.36F, 0, 0), 3);
  f.put(ItemKind::Television, index, eastWall(room, d / 2) * at(0, 0, 1.9F));
  f.put(ItemKind::TrashBin, index, eastWall(room, d / 2 + 1.4F) * at(0.3F, 0, 0));
  putAlongWalls(f, index, ItemKind::Wheelchair, 2);
  putAlongWalls(f, index, ItemKind::Chair, 3);
  for (const float x : {-0.8F, -0.62F, 0.62F, 0.8F}) hang(f, index, nearWall(x * room.width_m() / 2));
  for (const float y : {0.25F, 0.75F}) {
    hang(f, index, westWall(room, y * d));
    hang(f, index, eastWall(room, y * d));
  }
}

void furnishDayRoom(Furnisher& f, std::size_t index) {
  const Room& room = f.plan().rooms[index];
  const float d = room.depth_m();
  addTable(f, index, at(-0.9F, d / 2, 0, f.rng().uniform(0.0F, 1.0F)), 3);
  addTable(f, index, at(0.9F, d / 2, 0, f.rng().uniform(0.0F, 1.0F)), 3);
  f.put(ItemKind::Television, index, westWall(room, d / 2) * at(0, 0, 1.75F));
  f.put(ItemKind::Plant, index, farWall(room, -room.width_m() / 2 + 0.7F) * at(0.6F, 0, 0));
  f.put(ItemKind::Plant, index, nearWall(room.width_m() / 2 - 0.7F) * at(0.6F, 0, 0));
  f.put(ItemKind::Shelf, index, eastWall(room, d / 2), {0, 1.4F});
  addRow(f, index, westWall(room, d / 2) * at(0.36F, 0, 0), 3);
  putAlongWalls(f, index, ItemKind::Chair, 4);
  putAlongWalls(f, index, ItemKind::Wheelchair, 1);
  putAlongWalls(f, index, ItemKind::TrashBin, 1);
  for (const float x : {-0.7F, 0.7F}) hang(f, index, nearWall(x * room.width_m() / 2));
  for (const float y : {0.2F, 0.8F}) {
    hang(f, index, westWall(room, y * d));
    hang(f, index, eastWall(room, y * d));
  }
}

void furnishNurseStation(Furnisher& f, std::size_t index) {
  const Room& room = f.plan().rooms[index];
  f.put(ItemKind::Counter, index, at(0, 1.5F, 0, -kPi / 2), {0, 4.2F});
  for (const float x : {-1.2F, 0.9F}) f.putNudged(ItemKind::Chair, index, at(x, 2.7F, 0, -kPi / 2));
  f.put(ItemKind::Desk, index, eastWall(room, room.depth_m() / 2 + 0.6F));
  f.putNudged(ItemKind::Chair, index, eastWall(room, room.depth_m() / 2 + 0.6F) * at(1.2F, 0, 0, kPi));
  f.put(ItemKind::Shelf, index, farWall(room, -2.6F), {0, 1.6F});
  f.put(ItemKind::Shelf, index, farWall(room, -0.8F), {0, 1.6F});
  f.put(ItemKind::Whiteboard, index, farWall(room, 1.6F) * at(0, 0, 1.7F));
  f.put(ItemKind::Whiteboard, index, westWall(room, room.depth_m() / 2) * at(0, 0, 1.7F));
  putAlongWalls(f, index, ItemKind::Trolley, 2);
  putAlongWalls(f, index, ItemKind::Plant, 1);
  putAlongWalls(f, index, ItemKind::TrashBin, 1);
  putAlongWalls(f, index, ItemKind::Chair, 2);
}

void furnishStore(Furnisher& f, std::size_t index) {
  const Room& room = f.plan().rooms[index];
  for (float x = -room.width_m() / 2 + 1.1F; x < room.width_m() / 2 - 0.8F; x += 1.75F)
    f.put(ItemKind::Shelf, index, farWall(room, x), {0, 1.5F});
  putAlongWalls(f, index, ItemKind::Bed, 2);
  putAlongWalls(f, index, ItemKind::Wheelchair, 3);
  putAlongWalls(f, index, ItemKind::Trolley, 2);
  putAlongWalls(f, index, ItemKind::IvStand, 4);
  putAlongWalls(f, index, ItemKind::Screen, 2);
  putAlongWalls(f, index, ItemKind::Chair, 3);
}

void furnishToilet(Furnisher& f, std::size_t index) {
  const Room& room = f.plan().rooms[index];
  for (const float x : {-0.75F, 0.75F}) f.put(ItemKind::Toilet, index, farWall(room, x));
  f.put(ItemKind::Basin, index, westWall(room, 2.3F));
  f.put(ItemKind::Basin, index, eastWall(room, 2.3F));
  putAlongWalls(f, index, ItemKind::TrashBin, 1);
}

void furnishBath(Furnisher& f, std::size_t index) {
  const Room& room = f.plan().rooms[index];
  f.put(ItemKind::Toilet, index, farWall(room, -room.width_m() / 2 + 0.9F));
  f.put(ItemKind::Basin, index, westWall(room, room.depth_m() / 2));
  f.put(ItemKind::Shelf, index, eastWall(room, room.depth_m() / 2), {0, 1.2F});
  putAlongWalls(f, index, ItemKind::Trolley, 1);
  putAlongWalls(f, index, ItemKind::Wheelchair, 1);
  putAlongWalls(f, index, ItemKind::Chair, 1);
  putAlongWalls(f, index, ItemKind::TrashBin, 1);
}

void furnishOffice(Furnisher& f, std::size_t index) {
  const Room& room = f.plan().rooms[index];
  f.put(ItemKind::Desk, index, westWall(room, room.depth_m() / 2 + 0.5F));
  f.putNudged(ItemKind::Chair, index, westWall(room, room.depth_m() / 2 + 0.5F) * at(1.15F, 0, 0, kPi));
  f.put(ItemKind::Whiteboard, index, eastWall(room, room.depth_m() / 2) * at(0, 0, 1.6F));
  putAlongWalls(f, index, ItemKind::Shelf, 1);
  putAlongWalls(f, index, ItemKind::Chair, 2);
  putAlongWalls(f, index, ItemKind::Plant, 1);
}

void furnishTreatment(Furnisher& f, std::size_t index, bool patients) {
  const Room& room = f.plan().rooms[index];
  addBedPlace(f, index, 2, westWall(room, room.depth_m() - 1.7F), patients);
  f.put(ItemKind::Basin, index, eastWall(room, room.depth_m() / 2));
  f.put(ItemKind::Desk, index, eastWall(room, room.depth_m() - 1.2F));
  putAlongWalls(f, index, ItemKind::Trolley, 2);
  putAlongWalls(f, index, ItemKind::Screen, 1);
  putAlongWalls(f, index, ItemKind::Chair, 2);
  hang(f, index, westWall(room, 1.4F));
}

void furnishUtility(Furnisher& f, std::size_t index) {
  const Room& room = f.plan().rooms[index];
  for (float x = -room.width_m() / 2 + 1.0F; x < room.width_m() / 2 - 0.7F; x += 1.6F)
    f.put(ItemKind::Shelf, index, farWall(room, x), {0, 1.4F});
  f.put(ItemKind::Basin, index, westWall(room, room.depth_m() / 2));
  putAlongWalls(f, index, ItemKind::Trolley, 1);
  putAlongWalls(f, index, ItemKind::TrashBin, 1);
  putAlongWalls(f, index, ItemKind::Chair, 1);
}

int anyPoster(Furnisher& f) {
  constexpr int kPosters[] = {0, 1, 2, 9, 10, 11, 12, 13, 14, 15};  // the others number wards and beds
  return kPosters[f.rng().uniform(0, 10)];
}

void addWindow(Furnisher& f, std::size_t index) {
  constexpr float kSill_m = 0.9F;
  const Room& room = f.plan().rooms[index];
  const float outer_m = static_cast<float>(f.plan().size_m.y());
  const Vector3f across = room.T_world_room * Vector3f(0, room.depth_m(), 0);
  if (across.y() > 0.1F && across.y() < outer_m - 0.1F) return;
  const bool ward = room.kind == RoomKind::Ward;
  const float width_m = ward ? 3.4F : std::min(3.4F, room.width_m() - 1.4F);
  f.put(ItemKind::Window, index, farWall(room, 0) * at(0, 0, kSill_m), {ward ? 3 : f.rng().uniform(0, 8), width_m});
}

void addDoor(Furnisher& f, const Door& door) {
  const Room& room = f.plan().rooms[door.room];
  if (room.kind == RoomKind::Corridor) return;
  const Isometry3f T_room_world = room.T_world_room.inverse();
  const auto local = [&](const Eigen::Vector2d& p) {
    return Vector3f(T_room_world * Vector3f(static_cast<float>(p.x()), static_cast<float>(p.y()), 0));
  };
  const float hinge = local(door.from_m).x();
  const float width_m = static_cast<float>((door.to_m - door.from_m).norm());
  if (door.state != DoorState::Passage) {
    const std::size_t owner = ownerOf(door);
    const Isometry3f T = f.plan().rooms[owner].T_world_room.inverse() * room.T_world_room;
    f.put(ItemKind::DoorLeaf, owner, T * at(hinge + 0.035F, 0, 0), {0, width_m - 0.07F, false, door.opening_rad});
  }
  const auto cell = static_cast<int>(door.room);
  const bool above = room.kind == RoomKind::Store || door.state == DoorState::Passage;  // its wall stays bare
  const float x = above ? hinge + width_m / 2 : hinge + width_m + 0.42F;
  const Isometry3f place = room.T_world_room * at(x, -kHalfWall_m, above ? 2.38F : 1.72F, -kPi / 2);
  f.put(ItemKind::Sign, door.corridor, f.plan().rooms[door.corridor].T_world_room.inverse() * place,
        {cell, above ? 0.9F : 0.6F});
}

}  // namespace wardslam::synth
