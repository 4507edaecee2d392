#include "hospital/hospital_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace wardslam::synth {
namespace {

constexpr std::uint32_t kSeeds = 30;

const Room& corridorA(const HospitalPlan& plan) { return plan.rooms[plan.corridorA]; }

/// Whether the segment lies on a side of the room, ends included.
bool liesOnSide(const Room& room, const Door& door) {
  for (const Eigen::Vector2d& p : {door.from_m, door.to_m}) {
    Eigen::AlignedBox2d grown = room.area_m;
    grown.min().array() -= 1e-6;
    grown.max().array() += 1e-6;
    const Eigen::Vector2d inside = (p - room.area_m.min()).cwiseMin(room.area_m.max() - p);
    if (!grown.contains(p) || inside.minCoeff() > 1e-6) return false;
  }
  return true;
}

TEST(HospitalPlan, IsMoreThan1500SquareMetresInEverySeed) {
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) EXPECT_GT(planHospital(seed).area_m2(), 1500.0) << seed;
}

TEST(HospitalPlan, HasEightWardsOfOneSizeAndAllTheOtherRooms) {
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    const HospitalPlan plan = planHospital(seed);
    std::vector<const Room*> wards;
    std::set<RoomKind> kinds;
    for (const Room& room : plan.rooms) {
      kinds.insert(room.kind);
      if (room.kind == RoomKind::Ward) wards.push_back(&room);
    }
    ASSERT_EQ(wards.size(), 8U);
    for (const Room* ward : wards) {
      EXPECT_TRUE(ward->area_m.sizes().isApprox(wards.front()->area_m.sizes(), 1e-9)) << ward->id;
    }
    for (const RoomKind kind : {RoomKind::NurseStation, RoomKind::Lobby, RoomKind::Store, RoomKind::Toilet})
      EXPECT_EQ(kinds.count(kind), 1U) << nameOf(kind);
  }
}

TEST(HospitalPlan, RoomsFillTheBuildingAndNoneLiesInAnother) {
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    const HospitalPlan plan = planHospital(seed);
    for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
      for (std::size_t k = i + 1; k < plan.rooms.size(); ++k) {
        const Eigen::AlignedBox2d common = plan.rooms[i].area_m.intersection(plan.rooms[k].area_m);
        const bool none = common.isEmpty() || common.volume() < 1e-6;
        EXPECT_TRUE(none) << plan.rooms[i].id << " and " << plan.rooms[k].id;
      }
      EXPECT_GT(plan.rooms[i].area_m.sizes().minCoeff(), 2.4) << plan.rooms[i].id;
    }
    EXPECT_NEAR(plan.area_m2(), plan.size_m.prod(), 1e-6) << seed;
  }
}

TEST(HospitalPlan, NamesAreGivenOnce) {
  const HospitalPlan plan = planHospital(3);
  std::set<std::string> ids;
  for (const Room& room : plan.rooms) EXPECT_TRUE(ids.insert(room.id).second) << room.id;
  EXPECT_EQ(ids.count("ward-8"), 1U);
}

TEST(HospitalPlan, DoorsLieInWallsThatTheirRoomsShareAndNotOnEachOther) {
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    const HospitalPlan plan = planHospital(seed);
    for (const Door& door : plan.doors) {
      EXPECT_TRUE(liesOnSide(plan.rooms[door.room], door)) << plan.rooms[door.room].id;
      EXPECT_TRUE(liesOnSide(plan.rooms[door.corridor], door)) << plan.rooms[door.room].id;
      for (const Door& other : plan.doors) {
        if (&other == &door) continue;
        EXPECT_GT((other.middle_m() - door.middle_m()).norm(), 0.5);
      }
    }
  }
}

TEST(HospitalPlan, HasACorridorOf60MetresWith8MetresOfBareWallsOnBothSides) {
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    const HospitalPlan plan = planHospital(seed);
    EXPECT_GE(corridorA(plan).area_m.sizes().x(), 60.0);
    EXPECT_EQ(plan.bare.room, plan.corridorA);
    EXPECT_NEAR(plan.bare.toX_m - plan.bare.fromX_m, 8.0, 1e-9);
    for (const Door& door : plan.doors) {
      if (door.corridor != plan.corridorA) continue;
      const auto [low, high] = std::minmax(door.from_m.x(), door.to_m.x());
      EXPECT_FALSE(high > plan.bare.fromX_m && low < plan.bare.toX_m) << plan.rooms[door.room].id;
    }
  }
}

TEST(HospitalPlan, DoorsAreOpenAjarAndShutAndSixWardsAreOpen) {
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    const HospitalPlan plan = planHospital(seed);
    std::set<DoorState> states;
    int openWards = 0;
    for (const Door& door : plan.doors) {
      states.insert(door.state);
      openWards += plan.rooms[door.room].kind == RoomKind::Ward && door.state == DoorState::Open ? 1 : 0;
    }
    EXPECT_EQ(states.size(), 4U);
    EXPECT_EQ(openWards, 6);
  }
}

TEST(HospitalPlan, AnotherSeedIsAnotherPlan) {
  EXPECT_TRUE(planHospital(1).size_m == planHospital(1).size_m);
  EXPECT_GT((planHospital(1).size_m - planHospital(2).size_m).norm(), 0.01);
}

TEST(HospitalPlan, KnowsWhichRoomIsWhere) {
  const HospitalPlan plan = planHospital(1);
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) EXPECT_EQ(plan.roomAt(plan.rooms[i].area_m.center()), i);
  EXPECT_EQ(plan.roomAt({-1, -1}), plan.rooms.size());
}

}  // namespace
}  // namespace wardslam::synth
