#include "hospital/hospital_furnisher.h"

#include <algorithm>
#include <utility>

#include "scene/mesh.h"

namespace wardslam::synth {

using Eigen::Isometry3f;

Item Furnisher::made(ItemKind kind, std::size_t room, const Looks& looks) {
  Item item;
  item.kind = kind;
  item.room = room;
  item.variant = looks.variant;
  item.size_m = looks.size_m;
  item.occupied = looks.occupied;
  item.opening_rad = looks.opening_rad;
  item.modelSeed = rng_.next();
  item.footprint_m = footprintOf(item);
  return item;
}

bool Furnisher::keep(Item item) {
  if (!placing_.isFree(item, items_)) return false;
  item.identity = static_cast<int>(items_.size()) + 1;
  item.number = ++counts_[classIdOf(item.kind)];
  items_.push_back(std::move(item));
  return true;
}

bool Furnisher::put(ItemKind kind, std::size_t room, const Isometry3f& T_room_item, const Looks& looks) {
  Item item = made(kind, room, looks);
  item.T_world_item = plan_.rooms[room].T_world_room * T_room_item;
  return keep(std::move(item));
}

bool Furnisher::putNudged(ItemKind kind, std::size_t room, const Isometry3f& T_room_item, const Looks& looks) {
  const float x = rng_.uniform(-0.05F, 0.05F);
  const float y = rng_.uniform(-0.05F, 0.05F);
  const Isometry3f nudge = at(x, y, 0, rng_.uniform(-0.12F, 0.12F));
  return put(kind, room, T_room_item * nudge, looks);
}

bool Furnisher::putAtWall(ItemKind kind, std::size_t room, const Looks& looks) {
  Item item = made(kind, room, looks);
  const auto T = placing_.atWall(item, room, items_, rng_);
  if (!T) return false;
  item.T_world_item = *T;
  return keep(std::move(item));
}

}  // namespace wardslam::synth
