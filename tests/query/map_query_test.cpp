#include "wardslam/query/map_query.h"

#include <gmock/gmock.h>

#include "support/hand_made_map.h"

namespace wardslam::query {
namespace {

using test::kChair;
using testing::ElementsAre;
using testing::IsEmpty;

class QueryTest : public testing::Test {
 protected:
  std::vector<mapping::ObjectId> ids(const ObjectFilter& filter) const {
    std::vector<mapping::ObjectId> ids;
    for (const auto* object : query_.objects(filter)) ids.push_back(object->id);
    return ids;
  }
  static ObjectFilter chairs() {
    ObjectFilter filter;
    filter.classId = kChair;
    return filter;
  }

  mapping::SemanticMap map_ = test::makeWard();
  MapQuery query_{map_};
};

TEST_F(QueryTest, WithoutAFilterGivesWhatStandsThereInOrderOfIds) {
  EXPECT_THAT(ids({}), ElementsAre(1, 2, 3, 4, 5, 7));
}

TEST_F(QueryTest, FindsByClass) { EXPECT_THAT(ids(chairs()), ElementsAre(1, 2, 4, 7)); }

TEST_F(QueryTest, FindsByState) {
  ObjectFilter filter;
  filter.states = {mapping::ObjectState::Gone};
  EXPECT_THAT(ids(filter), ElementsAre(6));
  filter.states = {mapping::ObjectState::Moved};
  EXPECT_THAT(ids(filter), ElementsAre(7));
}

TEST_F(QueryTest, FindsByZoneHoweverDeeplyItLies) {
  ObjectFilter filter;
  filter.zone = "clean zone";
  EXPECT_THAT(ids(filter), ElementsAre(1, 2, 3));
  filter.zone = "ward";
  EXPECT_THAT(ids(filter), ElementsAre(1, 2, 3, 4, 5, 7));
  filter.zone = "elsewhere";
  EXPECT_THAT(ids(filter), IsEmpty());
}

TEST_F(QueryTest, FindsWhatReachesIntoABox) {
  ObjectFilter filter;
  filter.box_m = Eigen::AlignedBox3d(Eigen::Vector3d(0.2, -1, 0), Eigen::Vector3d(3.8, 1, 1));  // the gone one too
  EXPECT_THAT(ids(filter), ElementsAre(1, 4));
}

TEST_F(QueryTest, FindsByTimeSinceLastSeen) {
  ObjectFilter filter;
  filter.unseenAtLeast_s = 30.0;
  EXPECT_THAT(ids(filter), ElementsAre(7));
  filter.unseenAtLeast_s.reset();
  filter.unseenAtMost_s = 30.0;
  EXPECT_THAT(ids(filter), ElementsAre(1, 2, 3, 4, 5));
}

TEST_F(QueryTest, AChairWithABagOnItIsNotFree) {
  ObjectFilter filter = chairs();
  filter.zone = "clean zone";
  filter.onlyFree = true;
  EXPECT_THAT(ids(filter), ElementsAre(1));
}

TEST_F(QueryTest, ABagBesideOrUnderAChairLeavesItFree) {
  map_.objects[3] = test::makeObject(3, test::kBackpack, {2.0, 2.0, 0.15}, {0.3, 0.3, 0.3});  // seat from 0.36 m on
  map_.objects[8] = test::makeObject(8, test::kBackpack, {0.3, 0.0, 0.45}, {0.3, 0.3, 0.9});  // seat ends at 0.125 m
  ObjectFilter filter = chairs();
  filter.onlyFree = true;
  const MapQuery query(map_);
  EXPECT_EQ(query.objects(filter).size(), 4U);
}

TEST_F(QueryTest, WhatIsGoneOccupiesNothing) {
  map_.objects[3].state = mapping::ObjectState::Gone;
  ObjectFilter filter = chairs();
  filter.onlyFree = true;
  EXPECT_EQ(MapQuery(map_).objects(filter).size(), 4U);
}

TEST_F(QueryTest, FindsTheNearestAsTheCrowFlies) {
  const auto found = query_.nearest(Eigen::Vector2d(3.0, 0.4), chairs());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->object->id, 4U);
  EXPECT_NEAR(found->distance_m, std::hypot(1.0, 0.4), 1e-12);
}

TEST_F(QueryTest, HeightCountsWhenItIsGiven) {
  const auto found = query_.nearest(Eigen::Vector3d(0.0, 0.0, 2.45), chairs());
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->distance_m, 2.0, 1e-12);
}

TEST_F(QueryTest, NothingIsNearestWhereNothingMatches) {
  ObjectFilter filter;
  filter.classId = core::ClassId{3};
  EXPECT_FALSE(query_.nearest(Eigen::Vector2d(0, 0), filter));
  EXPECT_FALSE(query_.nearestAlongFloor({0, 0}, filter));
}

TEST_F(QueryTest, TheWayAlongTheFloorLeadsAroundWalls) {
  const auto found = query_.nearestAlongFloor({2.5, 0.4}, chairs());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->object->id, 2U) << "chair 4 is nearer, but behind the wall";

  ObjectFilter behindTheWall = chairs();
  behindTheWall.box_m = Eigen::AlignedBox3d(Eigen::Vector3d(3.5, -1, 0), Eigen::Vector3d(4.5, 1, 1));
  const auto far = query_.nearestAlongFloor({2.5, 0.0}, behindTheWall);
  ASSERT_TRUE(far);
  EXPECT_EQ(far->object->id, 4U);
  // To the end of the wall at (3…3.2, 4), past it, and back to 0.6 m before the chair's edge at y = 0.25.
  const double shortest_m = std::hypot(0.5, 4.0) + 0.2 + std::hypot(0.55, 4.0 - 0.85);
  EXPECT_GT(far->distance_m, shortest_m - 0.3);
  EXPECT_LT(far->distance_m, 1.08 * shortest_m + 0.3);
}

TEST_F(QueryTest, NoWayLeadsThroughAForbiddenZone) {
  ObjectFilter behindTheWall = chairs();
  behindTheWall.box_m = Eigen::AlignedBox3d(Eigen::Vector3d(3.5, -1, 0), Eigen::Vector3d(4.5, 1, 1));
  map_.zones.push_back({"store", {{2.5, 3.5}, {3.5, 3.5}, {3.5, 5.0}, {2.5, 5.0}}});
  EXPECT_TRUE(MapQuery(map_).nearestAlongFloor({2.5, 0.0}, behindTheWall)) << "a place forbids nothing";
  map_.zones.back().type = mapping::ZoneType::Forbidden;
  EXPECT_FALSE(MapQuery(map_).nearestAlongFloor({2.5, 0.0}, behindTheWall));
}

TEST_F(QueryTest, NoWayLeadsWhereTheFloorIsUnknown) {
  map_.floorPlan.cells.setTo(mapping::FloorPlan::kUnknown);
  EXPECT_FALSE(MapQuery(map_).nearestAlongFloor({0, 1}, chairs()));
  map_.floorPlan = {};
  EXPECT_FALSE(MapQuery(map_).nearestAlongFloor({0, 1}, chairs()));
}

TEST_F(QueryTest, TellsWhatIsAtAPoint) {
  const auto place = query_.at({2.0, 2.0, 0.6});
  ASSERT_EQ(place.objects.size(), 2U);
  EXPECT_EQ(place.objects[0]->id, 3U) << "the bag is smaller than the chair it lies on";
  EXPECT_EQ(place.objects[1]->id, 2U);
  EXPECT_THAT(place.zones, ElementsAre("clean zone", "ward"));
  EXPECT_EQ(place.floor, mapping::FloorPlan::kFree);
}

TEST_F(QueryTest, TellsTheFloorOfAPoint) {
  EXPECT_EQ(query_.at({3.1, 0.0, 0.0}).floor, mapping::FloorPlan::kOccupied);
  EXPECT_EQ(query_.at({0.0, 4.95, 0.0}).floor, mapping::FloorPlan::kUnknown);
  EXPECT_EQ(query_.at({-1.01, 0.0, 0.0}).floor, mapping::FloorPlan::kUnknown) << "outside";
  EXPECT_THAT(query_.at({-1.01, 0.0, 0.0}).zones, IsEmpty());
  EXPECT_THAT(query_.at({1.0, 0.0, 0.5}).objects, IsEmpty()) << "that chair is gone";
}

TEST(MapQuery, AnswersAboutAnEmptyMap) {
  const mapping::SemanticMap empty;
  const MapQuery query(empty);
  EXPECT_THAT(query.objects(), IsEmpty());
  EXPECT_FALSE(query.nearest(Eigen::Vector3d(0, 0, 0), {}));
  EXPECT_EQ(query.at({0, 0, 0}).floor, mapping::FloorPlan::kUnknown);
}

}  // namespace
}  // namespace wardslam::query
