#include "sighting_intervals.h"

#include <gtest/gtest.h>

#include "support/hand_made_map.h"

namespace wardslam::fleet {
namespace {

using mapping::ObjectState;

/// A chair that was seen at (1, 0) from 10 s to 20 s.
mapping::MapObject chairAt(double x_m, double last_s, ObjectState state = ObjectState::Static) {
  auto chair = test::makeChair(1, x_m, 0.0);
  chair.firstSeen_s = 10.0;
  chair.lastSeen_s = last_s;
  chair.zone = "ward";
  chair.state = state;
  return chair;
}

Stay firstStay() { return *updateStays({}, {}, chairAt(1.0, 20.0), {}, 20.0).next; }

StayUpdate after(const Stay& last, const mapping::MapObject& now, const Traces& traces = {}) {
  return updateStays(last, last.place_m, now, traces, 100.0);
}

TEST(SightingIntervals, BeginsWithTheFirstSighting) {
  EXPECT_EQ(firstStay().since_s, 10.0);
  EXPECT_EQ(firstStay().until_s, 20.0);
  EXPECT_EQ(firstStay().zone, "ward");
  EXPECT_EQ(firstStay().ended, "");
}

TEST(SightingIntervals, GoesOnWhereTheThingStays) {
  const auto update = after(firstStay(), chairAt(1.1, 40.0));
  EXPECT_FALSE(update.next);
  EXPECT_EQ(update.change, "");
  EXPECT_EQ(update.last->since_s, 10.0);
  EXPECT_EQ(update.last->until_s, 40.0);
  EXPECT_EQ(update.last->place_m.x(), 1.1);
}

TEST(SightingIntervals, AMoveEndsTheOneAndBeginsTheNext) {
  const auto seen = after(firstStay(), chairAt(3.0, 40.0, ObjectState::Moved));
  EXPECT_EQ(seen.change, "moved");
  EXPECT_EQ(seen.last->until_s, 20.0);
  EXPECT_EQ(seen.last->ended, "moved");
  EXPECT_EQ(seen.last->ended_s, 40.0);
  EXPECT_EQ(seen.next->since_s, 40.0);
  const auto handled = after(firstStay(), chairAt(3.0, 40.0, ObjectState::Moved), {30.0, 0.0});
  EXPECT_EQ(handled.last->ended_s, 30.0);
  EXPECT_EQ(handled.next->since_s, 30.0);
  EXPECT_EQ(handled.next->until_s, 40.0);
}

TEST(SightingIntervals, WhatTheMapCorrectedHasNotMoved) {
  const auto corrected = updateStays(firstStay(), {3.0, 0.0, 0.45}, chairAt(3.0, 40.0, ObjectState::Moved), {}, 100.0);
  EXPECT_EQ(corrected.change, "");
  EXPECT_EQ(after(firstStay(), chairAt(3.0, 40.0, ObjectState::Static)).change, "");
}

TEST(SightingIntervals, WhatIsGoneEndsAndMayComeBack) {
  const auto gone = after(firstStay(), chairAt(1.0, 20.0, ObjectState::Gone), {0.0, 60.0});
  EXPECT_EQ(gone.change, "gone");
  EXPECT_EQ(gone.last->ended, "gone");
  EXPECT_EQ(gone.last->ended_s, 60.0);
  EXPECT_EQ(after(*gone.last, chairAt(1.0, 20.0, ObjectState::Gone)).change, "");
  const auto back = after(*gone.last, chairAt(1.0, 80.0));
  EXPECT_EQ(back.change, "back");
  EXPECT_FALSE(back.last);
  EXPECT_EQ(back.next->since_s, 80.0);
}

}  // namespace
}  // namespace wardslam::fleet
