#include "hospital/hospital_furnishing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "hospital/hospital_building.h"

namespace wardslam::synth {
namespace {

/// Everything of a room, in the room's own frame: materials and vertices, in their order.
std::vector<Surface> ownSurfaces(const HospitalPlan& plan, const std::vector<Item>& items, std::size_t room) {
  std::vector<Surface> all;
  const Eigen::Isometry3f T_room_world = plan.rooms[room].T_world_room.inverse();
  for (const Item& item : items) {
    if (item.room != room || item.kind == ItemKind::DoorLeaf) continue;
    for (Surface& surface : modelOf(item)) {
      surface.mesh.transform(T_room_world * item.T_world_item);
      all.push_back(std::move(surface));
    }
  }
  return all;
}

float largestDifference_m(const std::vector<Surface>& a, const std::vector<Surface>& b) {
  if (a.size() != b.size()) return 1e6F;
  float largest = 0.0F;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto& p = a[i].mesh.vertices;
    const auto& q = b[i].mesh.vertices;
    if (a[i].material != b[i].material || p.size() != q.size()) return 1e6F;
    for (std::size_t k = 0; k < p.size(); ++k)
      largest = std::max({largest, (p[k].p_m - q[k].p_m).norm(), (p[k].uv - q[k].uv).norm()});
  }
  return largest;
}

std::vector<std::size_t> wardsOf(const HospitalPlan& plan) {
  std::vector<std::size_t> wards;
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
    if (plan.rooms[i].kind == RoomKind::Ward) wards.push_back(i);
  }
  return wards;
}

TEST(HospitalFurnishing, WardsCannotBeToldApart) {
  for (const std::uint32_t seed : {1U, 2U, 5U}) {
    const HospitalPlan plan = planHospital(seed);
    const std::vector<Item> items = furnish(plan, seed, true);
    const auto wards = wardsOf(plan);
    const auto first = ownSurfaces(plan, items, wards.front());
    EXPECT_GT(first.size(), 60U);
    for (const std::size_t ward : wards)
      EXPECT_LT(largestDifference_m(first, ownSurfaces(plan, items, ward)), 1e-4F) << plan.rooms[ward].id;
  }
}

TEST(HospitalFurnishing, WallsOfWardsCannotBeToldApart) {
  const HospitalPlan plan = planHospital(1);
  const std::vector<Thing> rooms = buildWalls(plan, 1);
  std::vector<std::vector<Surface>> wards;
  for (const std::size_t ward : wardsOf(plan)) {
    // A shut door's frame belongs to the corridor.
    const auto door = std::find_if(plan.doors.begin(), plan.doors.end(), [&](const Door& d) { return d.room == ward; });
    if (door->state == DoorState::Closed) continue;
    wards.push_back(rooms[ward].surfaces);
    for (Surface& surface : wards.back()) surface.mesh.transform(plan.rooms[ward].T_world_room.inverse());
  }
  ASSERT_GE(wards.size(), 6U);
  for (const auto& ward : wards) EXPECT_LT(largestDifference_m(wards.front(), ward), 1e-4F);
}

TEST(HospitalFurnishing, HasWhatAHospitalHas) {
  const HospitalPlan plan = planHospital(1);
  std::map<ItemKind, int> counts;
  int occupied = 0;
  for (const Item& item : furnish(plan, 1, true)) {
    ++counts[item.kind];
    occupied += item.occupied ? 1 : 0;
  }
  EXPECT_GE(counts[ItemKind::Bed], 34);
  EXPECT_GE(occupied, 16);
  EXPECT_GT(counts[ItemKind::Bed], occupied);
  for (const ItemKind kind : {ItemKind::Curtain, ItemKind::IvStand, ItemKind::Trolley, ItemKind::Wheelchair,
                              ItemKind::Chair, ItemKind::Screen, ItemKind::Window, ItemKind::Sign, ItemKind::DoorLeaf})
    EXPECT_GE(counts[kind], 8) << classNameOf(kind);
}

TEST(HospitalFurnishing, NobodyLiesThereWhenNobodyShall) {
  for (const Item& item : furnish(planHospital(1), 1, false)) EXPECT_FALSE(item.occupied);
}

TEST(HospitalFurnishing, ThingsAreCountedAndDoNotStandInEachOther) {
  for (const std::uint32_t seed : {1U, 4U}) {
    const std::vector<Item> items = furnish(planHospital(seed), seed, true);
    for (std::size_t i = 0; i < items.size(); ++i) {
      EXPECT_EQ(items[i].identity, static_cast<int>(i) + 1);
      for (std::size_t k = 0; k < i; ++k) {
        if (items[i].room == items[k].room) {
          EXPECT_FALSE(collide(items[i], items[k], 0.0)) << nameOf(items[i]) << " in " << nameOf(items[k]);
        }
      }
    }
  }
}

TEST(HospitalFurnishing, NothingHangsOrStandsAtTheBareWalls) {
  const HospitalPlan plan = planHospital(1);
  for (const Item& item : furnish(plan, 1, true)) {
    const Eigen::Vector2d p = item.T_world_item.translation().head<2>().cast<double>();
    const bool there = item.room == plan.corridorA && p.x() > plan.bare.fromX_m && p.x() < plan.bare.toX_m;
    if (there) {
      EXPECT_EQ(item.kind, ItemKind::HangingSign) << nameOf(item);
    }
  }
}

TEST(HospitalFurnishing, TheSameSeedFurnishesTheSame) {
  const HospitalPlan plan = planHospital(7);
  const auto a = furnish(plan, 7, true);
  const auto b = furnish(plan, 7, true);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].modelSeed, b[i].modelSeed);
    EXPECT_TRUE(a[i].T_world_item.matrix() == b[i].T_world_item.matrix());
  }
}

}  // namespace
}  // namespace wardslam::synth
