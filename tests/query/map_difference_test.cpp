#include "wardslam/query/map_difference.h"

#include <gtest/gtest.h>

#include "support/hand_made_map.h"

namespace wardslam::query {
namespace {

using test::makeChair;

TEST(MapDifference, AMapDiffersFromItselfInNothing) {
  const auto ward = test::makeWard();
  const auto same = difference(ward, ward);
  EXPECT_TRUE(same.moved.empty() && same.gone.empty() && same.added.empty());
  EXPECT_EQ(same.unchanged, 6U) << "the one that is gone does not count";
}

TEST(MapDifference, TellsMovedGoneAndNew) {
  mapping::SemanticMap before;
  before.objects[1] = makeChair(1, 0, 0);
  before.objects[2] = makeChair(2, 5, 0);
  before.objects[3] = test::makeObject(3, test::kBed, {0, 3, 0.4}, {1, 2, 0.8});
  mapping::SemanticMap after;
  after.objects[7] = makeChair(7, 0.1, 0);
  after.objects[8] = makeChair(8, 5, 2);
  after.objects[9] = test::makeObject(9, test::kBackpack, {0, 3, 0.4}, {0.3, 0.3, 0.4});

  const auto changes = difference(before, after);
  EXPECT_EQ(changes.unchanged, 1U);
  ASSERT_EQ(changes.moved.size(), 1U);
  EXPECT_EQ(changes.moved[0].before->id, 2U);
  EXPECT_EQ(changes.moved[0].after->id, 8U);
  EXPECT_NEAR(changes.moved[0].distance_m, 2.0, 1e-12);
  ASSERT_EQ(changes.gone.size(), 1U);
  EXPECT_EQ(changes.gone[0]->id, 3U);
  ASSERT_EQ(changes.added.size(), 1U);
  EXPECT_EQ(changes.added[0]->id, 9U);
}

TEST(MapDifference, WhatStandsStillKeepsItsPartnerThoughAnotherMovedNearby) {
  mapping::SemanticMap before;
  before.objects[1] = makeChair(1, 0, 0);
  before.objects[2] = makeChair(2, 1, 0);
  mapping::SemanticMap after;
  after.objects[1] = makeChair(1, 1.02, 0);  // chair 2 of before
  after.objects[2] = makeChair(2, 1.9, 0);   // chair 1 of before, carried past it
  const auto changes = difference(before, after);
  EXPECT_EQ(changes.unchanged, 1U);
  ASSERT_EQ(changes.moved.size(), 1U);
  EXPECT_EQ(changes.moved[0].before->id, 1U);
  EXPECT_EQ(changes.moved[0].after->id, 2U);
}

TEST(MapDifference, HowFarIsMovedIsTheCallersChoice) {
  mapping::SemanticMap before;
  before.objects[1] = makeChair(1, 0, 0);
  mapping::SemanticMap after;
  after.objects[1] = makeChair(1, 0.5, 0);
  EXPECT_EQ(difference(before, after).moved.size(), 1U);
  EXPECT_EQ(difference(before, after, 0.6).unchanged, 1U);
}

TEST(MapDifference, TurningGoneIsGone) {
  mapping::SemanticMap before;
  before.objects[1] = makeChair(1, 0, 0);
  mapping::SemanticMap after = before;
  after.objects[1].state = mapping::ObjectState::Gone;
  EXPECT_EQ(difference(before, after).gone.size(), 1U);
}

TEST(MapDifference, AThingCanBeBroughtIntoAnotherFrame) {
  mapping::MapObject bed = test::makeObject(3, test::kBed, {1, 0, 0.4}, {1, 2, 0.8});
  const Eigen::Isometry3d T_other_map =
      Eigen::Translation3d(10, 0, 1) * Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ());
  moveObject(bed, T_other_map);
  EXPECT_TRUE(bed.centroid_m.isApprox(Eigen::Vector3d(10, 1, 1.4), 1e-12));
  EXPECT_TRUE(bed.box_m.min().isApprox(Eigen::Vector3d(9, 0.5, 1.0), 1e-12)) << "lengths of 1 m and 2 m, turned";
  EXPECT_TRUE(bed.box_m.max().isApprox(Eigen::Vector3d(11, 1.5, 1.8), 1e-12));
  EXPECT_TRUE(bed.orientedBox.T_map_box.translation().isApprox(Eigen::Vector3d(10, 1, 1.4), 1e-12));
}

}  // namespace
}  // namespace wardslam::query
