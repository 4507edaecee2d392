#include "hospital/hospital_days.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "hospital/hospital_furnishing.h"

namespace wardslam::synth {
namespace {

using What = DayChange::What;

std::map<int, Item> byIdentity(const std::vector<Item>& items) {
  std::map<int, Item> all;
  for (const Item& item : items) EXPECT_TRUE(all.emplace(item.identity, item).second) << nameOf(item);
  return all;
}

bool sameThing(const Item& a, const Item& b) {
  return a.kind == b.kind && a.modelSeed == b.modelSeed && a.number == b.number && a.occupied == b.occupied;
}

bool samePlace(const Item& a, const Item& b) {
  return a.room == b.room && a.T_world_item.matrix() == b.T_world_item.matrix();
}

class HospitalDays : public ::testing::Test {
 protected:
  HospitalPlan plan = planHospital(1);
  std::vector<Item> day0 = furnish(plan, 1, true);
};

TEST_F(HospitalDays, DayZeroIsAsFurnished) {
  const HospitalDay today = daysLater(plan, day0, 0, 1);
  EXPECT_TRUE(today.changes.empty());
  EXPECT_EQ(today.items.size(), day0.size());
}

TEST_F(HospitalDays, WhatDiffersFromTheDayBeforeIsWhatTheChangesSay) {
  const HospitalDay before = daysLater(plan, day0, 2, 1);
  const HospitalDay after = daysLater(plan, day0, 3, 1);
  std::map<int, DayChange> said;
  for (const DayChange& change : after.changes) {
    if (change.day != 3) continue;
    const int identity = change.before ? change.before->identity : change.after->identity;
    EXPECT_TRUE(said.emplace(identity, change).second);
  }
  const auto was = byIdentity(before.items);
  const auto is = byIdentity(after.items);
  for (const auto& [identity, item] : was) {
    if (is.count(identity) == 0) {
      ASSERT_EQ(said.count(identity), 1U);
      EXPECT_EQ(said.at(identity).what, What::Gone);
      continue;
    }
    EXPECT_TRUE(sameThing(item, is.at(identity)));
    EXPECT_EQ(samePlace(item, is.at(identity)), said.count(identity) == 0) << nameOf(item);
    if (said.count(identity) == 0) continue;
    EXPECT_TRUE(samePlace(*said.at(identity).before, item));
    EXPECT_TRUE(samePlace(*said.at(identity).after, is.at(identity)));
  }
  for (const auto& [identity, item] : is) {
    if (was.count(identity) != 0) continue;
    ASSERT_EQ(said.count(identity), 1U);
    EXPECT_EQ(said.at(identity).what, What::New);
    EXPECT_GE(identity, kFirstNewIdentity);
  }
}

TEST_F(HospitalDays, EveryDayThingsAreMovedSwappedTakenAwayAndBrought) {
  const HospitalDay today = daysLater(plan, day0, 5, 1);
  std::map<int, std::map<What, int>> counts;
  for (const DayChange& change : today.changes) ++counts[change.day][change.what];
  for (int day = 1; day <= 5; ++day) {
    EXPECT_GE(counts[day][What::Moved], 8) << day;
    EXPECT_GE(counts[day][What::Swapped], 4) << day;
    EXPECT_GE(counts[day][What::Gone], 2) << day;
    EXPECT_GE(counts[day][What::New], 2) << day;
  }
}

TEST_F(HospitalDays, WhatIsSwappedTakesTheOthersPlaceInAWardThatLooksTheSame) {
  const HospitalDay today = daysLater(plan, day0, 1, 1);
  std::vector<DayChange> swaps;
  for (const DayChange& change : today.changes) {
    if (change.what == What::Swapped) swaps.push_back(change);
  }
  ASSERT_GE(swaps.size(), 4U);
  for (std::size_t i = 0; i + 1 < swaps.size(); i += 2) {
    EXPECT_TRUE(samePlace(*swaps[i].before, *swaps[i + 1].after));
    EXPECT_TRUE(samePlace(*swaps[i].after, *swaps[i + 1].before));
    EXPECT_NE(swaps[i].before->room, swaps[i].after->room);
    EXPECT_EQ(plan.rooms[swaps[i].after->room].kind, RoomKind::Ward);
  }
}

TEST_F(HospitalDays, NothingStandsInAnythingElseAfterManyDays) {
  const HospitalDay today = daysLater(plan, day0, 12, 1);
  for (const Item& a : today.items) {
    for (const Item& b : today.items) {
      if (a.identity < b.identity && a.room == b.room) {
        EXPECT_FALSE(collide(a, b, 0.0)) << nameOf(a) << " in " << nameOf(b);
      }
    }
  }
}

TEST_F(HospitalDays, ADayIsTheSameHoweverOneComesToIt) {
  const HospitalDay a = daysLater(plan, day0, 4, 1);
  const HospitalDay b = daysLater(plan, day0, 4, 1);
  ASSERT_EQ(a.items.size(), b.items.size());
  for (std::size_t i = 0; i < a.items.size(); ++i) EXPECT_TRUE(samePlace(a.items[i], b.items[i]));
  // Day 4 of another seed is another day.
  const HospitalDay other = daysLater(plan, day0, 4, 2);
  std::set<int> differing;
  for (std::size_t i = 0; i < std::min(a.items.size(), other.items.size()); ++i) {
    if (!samePlace(a.items[i], other.items[i])) differing.insert(a.items[i].identity);
  }
  EXPECT_GT(differing.size(), 5U);
}

}  // namespace
}  // namespace wardslam::synth
