#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "scene/scene.h"

/// What stands and hangs in a hospital, as things with an identity that lasts over all days.
namespace wardslam::synth {

enum class ItemKind {
  Bed,
  Cabinet,
  IvStand,
  Chair,
  Trolley,
  Wheelchair,
  Screen,
  TrashBin,
  Plant,
  Table,
  Curtain,
  Shelf,
  Counter,
  Desk,
  Toilet,
  Basin,
  DoorLeaf,
  Window,
  Picture,
  Sign,
  HangingSign,
  Outlets,
  Monitor,
  Television,
  Extinguisher,
  Dispenser,
  Whiteboard
};

struct Item {
  int identity = 0;
  ItemKind kind = ItemKind::Chair;
  int number = 0;       ///< Among all of its class; its name ends with it.
  int variant = 0;      ///< Poster, cell of the signs, chart, who lies in a bed.
  float size_m = 1.0F;  ///< Width or length, of what comes in several.
  float opening_rad = 0.0F;
  bool occupied = false;        ///< Of a bed: somebody lies in it.
  std::uint64_t modelSeed = 0;  ///< The same seed, the same looks.
  std::size_t room = 0;
  Eigen::Isometry3f T_world_item = Eigen::Isometry3f::Identity();
  Eigen::AlignedBox2d footprint_m;  ///< Own frame, of all below kHeadroom_m; empty for what hangs higher or flat.
};

constexpr float kHeadroom_m = 1.35F;
constexpr float kHospitalCeiling_m = 2.9F;

[[nodiscard]] core::ClassId classIdOf(ItemKind kind);
[[nodiscard]] const char* classNameOf(ItemKind kind);
/// Beds, chairs, trolleys, wheelchairs and the like, which are found elsewhere on another day.
[[nodiscard]] bool isMovable(ItemKind kind);
[[nodiscard]] std::string nameOf(const Item& item);

/// In its own frame.
[[nodiscard]] Surfaces modelOf(const Item& item);
/// Empty for what hangs flat on a wall.
[[nodiscard]] Eigen::AlignedBox2d footprintOf(const Item& item);

/// The middle of an item's footprint, world frame.
[[nodiscard]] Eigen::Vector2d middleOf(const Item& item);
/// Distance from the place to the footprint; 0 within, infinite when it has none.
[[nodiscard]] double distanceTo(const Item& item, const Eigen::Vector2d& p_m);
/// Whether footprints come closer than `gap_m` to each other.
[[nodiscard]] bool collide(const Item& a, const Item& b, double gap_m);

}  // namespace wardslam::synth
