#include "relative_stamps.h"

#include <gtest/gtest.h>

namespace wardslam::storage {
namespace {

constexpr double kStart_s = 1305031102.25;

TEST(RelativeStamps, AllOfTheChangesAreSecondsSinceTheStart) {
  MapChanges changes;
  changes.keyframes[1].stamp_s = kStart_s;
  changes.keyframes[2].stamp_s = kStart_s + 2.5;
  changes.objects.emplace_back();
  changes.objects[0].firstSeen_s = kStart_s + 0.5;
  changes.objects[0].lastSeen_s = kStart_s + 1.5;
  makeStampsRelative(changes, kStart_s);
  EXPECT_EQ(changes.keyframes[1].stamp_s, 0.0);
  EXPECT_EQ(changes.keyframes[2].stamp_s, 2.5);
  EXPECT_EQ(changes.objects[0].firstSeen_s, 0.5);
  EXPECT_EQ(changes.objects[0].lastSeen_s, 1.5);
}

TEST(RelativeStamps, WhatIsRememberedFollowsAndNeverStaysNever) {
  mapping::MapMemory memory;
  auto& object = memory.objects[7];
  object.firstSeen_s = kStart_s + 0.5;
  object.lastSeen_s = kStart_s + 1.5;
  object.handled_s = kStart_s + 0.75;
  makeStampsRelative(memory, kStart_s);
  EXPECT_EQ(object.firstSeen_s, 0.5);
  EXPECT_EQ(object.lastSeen_s, 1.5);
  EXPECT_EQ(object.handled_s, 0.75);
  EXPECT_EQ(object.gone_s, 0.0);
}

}  // namespace
}  // namespace wardslam::storage
