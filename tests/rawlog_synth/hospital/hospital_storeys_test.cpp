#include "hospital/hospital_storeys.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>

#include "hospital/hospital_furnishing.h"
#include "hospital/hospital_identities.h"
#include "hospital/hospital_scene.h"
#include "scene/classes.h"
#include "wardslam/core/errors.h"

namespace wardslam::synth {
namespace {

HospitalOptions storeys(int count, int driven, Density people) {
  HospitalOptions options;
  options.people = people;
  options.route.kind = RouteKind::Lobby;
  options.storeys = count;
  options.storey = driven;
  return options;
}

Eigen::AlignedBox3f boundsOf(const Surfaces& surfaces) {
  Eigen::AlignedBox3f box_m;
  for (const Surface& surface : surfaces) {
    for (const Vertex& vertex : surface.mesh.vertices) box_m.extend(vertex.p_m);
  }
  return box_m;
}

TEST(HospitalStoreys, HaveOneOutlineAndWardsOfOneSizeButRoomsOfTheirOwn) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const HospitalPlan ground = planHospital(seed);
    for (int storey = 1; storey < kMostStoreys; ++storey) {
      const HospitalPlan plan = planHospital(seed, storey);
      EXPECT_EQ(plan.size_m, ground.size_m);
      std::set<std::string> ids;
      for (const Room& room : ground.rooms) ids.insert(room.id);
      for (const Room& room : plan.rooms) EXPECT_TRUE(ids.insert(room.id).second) << room.id;
      bool differs = false;
      for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
        differs = differs || !plan.rooms[i].area_m.isApprox(ground.rooms[i].area_m);
        if (plan.rooms[i].kind != RoomKind::Ward) continue;
        EXPECT_EQ(plan.rooms[i].name.size(), std::string("WARD 11").size()) << plan.rooms[i].name;
        EXPECT_EQ(plan.rooms[i].name.substr(0, 6), "WARD " + std::to_string(storey));
      }
      EXPECT_TRUE(differs);
    }
  }
}

TEST(HospitalStoreys, IdentitiesAreGivenOnceInTheBuildingOnAllDays) {
  std::set<int> identities;
  std::set<std::pair<ItemKind, int>> names;
  for (int storey = 0; storey < kMostStoreys; ++storey) {
    const HospitalPlan plan = planHospital(1, storey);
    const HospitalDay today = daysLater(plan, furnish(plan, 1, true), 3, 1);
    EXPECT_GT(today.items.size(), 300U);
    for (const Item& item : today.items) {
      EXPECT_TRUE(identities.insert(item.identity).second) << nameOf(item);
      EXPECT_TRUE(names.insert({item.kind, item.number}).second) << nameOf(item);
      const bool isNew = item.identity >= kFirstNewIdentity;
      const int first = isNew ? firstNewIdentity(storey) : 1 + kIdentitiesPerStorey * storey;
      EXPECT_GE(item.identity, first);
      EXPECT_LT(item.identity, first + (isNew ? 10000 : kIdentitiesPerStorey));
      EXPECT_LT(item.occupied ? item.number : 0, kNumbersPerStorey * (storey + 1));
    }
  }
}

TEST(HospitalStoreys, StandOneAboveTheOtherAndTellThemselvesApart) {
  const Setting setting = hospitalSetting({}, storeys(2, 1, Density::Few), {});
  std::set<int> ids;
  std::map<int, int> things;
  for (const Thing& thing : setting.scene.things) {
    const Eigen::AlignedBox3f box_m = boundsOf(thing.surfaces);
    const int storey = setting.storeyAt(static_cast<double>(box_m.center().z()));
    ++things[storey];
    EXPECT_GE(box_m.min().z(), 3.6F * static_cast<float>(storey) - 0.01F) << thing.label.name;
    EXPECT_LE(box_m.max().z(), 3.6F * static_cast<float>(storey) + 2.95F) << thing.label.name;
    if (thing.label.id == 0) continue;
    EXPECT_TRUE(ids.insert(thing.label.id).second) << thing.label.name;
    const bool isGround = thing.label.id <= 2000 || (thing.label.id >= 40000 && thing.label.id < 41000);
    EXPECT_EQ(storey, isGround ? 0 : 1) << thing.label.id;
    const std::string room = setting.roomAt(box_m.center().cast<double>());
    EXPECT_EQ(room.substr(0, 3) == "s1-", storey == 1) << room;
  }
  EXPECT_GT(things[0], 300);
  EXPECT_GT(things[1], 300);
}

TEST(HospitalStoreys, PeopleLiveOnEachAndTheCameraDrivesOnItsOwn) {
  const Setting setting = hospitalSetting({}, storeys(2, 1, Density::Few), {});
  const Setting below = hospitalSetting({}, storeys(2, 0, Density::Few), {});
  std::map<int, int> people;
  std::set<int> ids;
  for (const auto& actor : setting.scene.actors) {
    EXPECT_TRUE(ids.insert(actor->label().id).second) << actor->label().name;
    if (actor->label().classId != kPerson) continue;
    const Eigen::AlignedBox3f box_m = boundsOf(actor->surfacesAt(1.0));
    const int storey = setting.storeyAt(static_cast<double>(box_m.center().z()));
    ++people[storey];
    EXPECT_NEAR(actor->floorZ_m(), 3.6 * storey, 1e-5);
    EXPECT_NEAR(box_m.min().z(), 3.6 * storey, 0.5) << actor->label().name;
    Eigen::AlignedBox3f bounds_m = actor->boundsAt(1.0);
    bounds_m.min().z() -= 0.02F;  // soles of who walks reach a centimetre into the floor
    EXPECT_TRUE(bounds_m.contains(box_m)) << actor->label().name;
  }
  EXPECT_GE(people[0], 10);
  EXPECT_GE(people[1], 10);
  EXPECT_NEAR(below.T_world_cam(0.0).translation().z(), 1.1, 0.1);
  EXPECT_NEAR(setting.T_world_cam(0.0).translation().z() - below.T_world_cam(0.0).translation().z(), 3.6, 1e-5);
}

TEST(HospitalStoreys, WhatIsMovedRestsOnTheFloorOfItsStorey) {
  const Setting setting = hospitalSetting({}, storeys(2, 1, Density::Few), {});
  std::map<int, int> rests;
  for (const auto& actor : setting.scene.actors) {
    for (const RestInterval& rest : actor->restsUntil(1.0)) {
      ++rests[setting.storeyAt(static_cast<double>(rest.bounds_m.center().z()))];
      EXPECT_NEAR(rest.bounds_m.min().z(), actor->floorZ_m(), 0.2F) << actor->label().name;
    }
  }
  EXPECT_GT(rests[0], 0);
  EXPECT_GT(rests[1], 0);
}

TEST(HospitalStoreys, OnlyTheOneThatIsDrivenOnMayBeSeen) {
  const Setting setting = hospitalSetting({}, storeys(2, 1, Density::None), {});
  const Eigen::Isometry3d T_world_cam = setting.T_world_cam(0.0);
  std::map<int, int> seen;
  for (const Thing& thing : setting.scene.things) {
    if (setting.scene.mayBeSeen(thing.cell, T_world_cam)) {
      ++seen[setting.storeyAt(static_cast<double>(boundsOf(thing.surfaces).center().z()))];
    }
  }
  EXPECT_EQ(seen[0], 0);
  EXPECT_GT(seen[1], 20);
}

TEST(HospitalStoreys, OneAloneIsTheGroundFloorAsItAlwaysWas) {
  const Setting setting = hospitalSetting({}, storeys(1, 0, Density::None), {});
  const Scene alone = buildHospital(makeHospital({1, false}, {}), 1);
  ASSERT_EQ(setting.scene.things.size(), alone.things.size());
  EXPECT_FALSE(setting.storeyAt) << "objects.csv has no column for it";
  EXPECT_EQ(setting.scene.things.back().cell, alone.things.back().cell);
}

TEST(HospitalStoreys, WhichThereIsNotIsRefused) {
  EXPECT_THROW((void)hospitalSetting({}, storeys(2, 2, Density::None), {}), core::InputError);
  EXPECT_EQ(storeyAt(-1.0, 3), 0);
  EXPECT_EQ(storeyAt(3.59, 3), 0);
  EXPECT_EQ(storeyAt(3.61, 3), 1);
  EXPECT_EQ(storeyAt(99.0, 3), 2);
}

}  // namespace
}  // namespace wardslam::synth
