#include "renumbering.h"

#include <gmock/gmock.h>

namespace wardslam::merging {
namespace {

using pipeline::EarlierMap;
using testing::ElementsAre;
using testing::Pair;

/// Keyframes 2 and 5 of piece 4, which is the map, and 7 of piece 3; point 11 seen by 2 and 5; thing 3 with the hint
/// that it may be 1; the next thing would be 4.
EarlierMap makeMap() {
  EarlierMap map;
  map.semantic.piece = map.graph.map = 4;
  for (const auto& [id, piece] : {std::pair(2U, 4U), std::pair(5U, 4U), std::pair(7U, 3U)}) {
    map.semantic.keyframes[id].piece = piece;
    auto keyframe = std::make_shared<odometry::Keyframe>();
    keyframe->id = id;
    keyframe->submap = piece;
    if (piece == 4) keyframe->sightings = {{11, id}};
    map.graph.keyframes.push_back(keyframe);
  }
  map.graph.p_map_m[11] = Eigen::Vector3d(1, 2, 3);
  graph::Loop loop;
  loop.older = 2;
  loop.newer = 5;
  map.graph.loops = {loop};
  map.semantic.objects[3].id = 3;
  map.semantic.objects[3].piece = 4;
  map.semantic.objects[3].maybeSameAs = mapping::MaybeSame{1, 0.5};
  map.semantic.nextObjectId = 4;
  map.semantic.cloud[5].points.resize(2);
  map.semantic.cloud[5].points[1].object = 3;
  map.memory.objects[3].piece = 4;
  map.memory.pairs[{1, 3}] = {2, 1};
  map.memory.tiles[5].resize(1);
  map.memory.tiles[5][0].object = 3;
  map.memory.tiles[5][0].votes[1] = {1, 0.5F};
  return map;
}

TEST(RenumberingTest, GivesNoNumberTwice) {
  EarlierMap first = makeMap();
  EarlierMap second = makeMap();
  renumber({&first, &second});

  const auto idsOf = [](const EarlierMap& map) {
    std::vector<odometry::KeyframeId> ids;
    for (const auto& keyframe : map.graph.keyframes) ids.push_back(keyframe->id);
    return ids;
  };
  EXPECT_THAT(idsOf(first), ElementsAre(1, 2, 3)) << "without gaps";
  EXPECT_THAT(idsOf(second), ElementsAre(4, 5, 6));
  EXPECT_EQ(first.semantic.keyframes.begin()->first, 1U);
  EXPECT_EQ(second.semantic.keyframes.rbegin()->first, 6U);

  EXPECT_EQ(first.semantic.piece, 1U) << "first the maps,";
  EXPECT_EQ(second.semantic.piece, 2U);
  EXPECT_EQ(second.graph.map, 2U);
  EXPECT_EQ(first.graph.keyframes[2]->submap, 3U) << "then what is not joined to them";
  EXPECT_EQ(second.graph.keyframes[2]->submap, 4U);
  EXPECT_EQ(second.semantic.keyframes.at(6).piece, 4U);
  EXPECT_EQ(first.graph.freeSubmap, 5U);
  EXPECT_EQ(second.graph.freeSubmap, 5U);
}

TEST(RenumberingTest, WhatNamesANumberNamesTheNewOne) {
  EarlierMap first = makeMap();
  EarlierMap second = makeMap();
  renumber({&first, &second});
  EXPECT_EQ(second.graph.p_map_m.begin()->first, 2U);
  EXPECT_EQ(second.graph.keyframes[1]->sightings.at(0).point, 2U);
  EXPECT_EQ(second.graph.keyframes[1]->sightings.at(0).keypoint, 5U) << "no number of a point";
  EXPECT_EQ(second.graph.loops.at(0).older, 4U);
  EXPECT_EQ(second.graph.loops.at(0).newer, 5U);

  EXPECT_EQ(first.semantic.objects.at(3).id, 3U) << "things of the first keep their numbers";
  EXPECT_EQ(second.semantic.objects.at(6).id, 6U) << "behind 3, the last of the first";
  EXPECT_EQ(second.semantic.objects.at(6).piece, 2U);
  EXPECT_EQ(second.semantic.objects.at(6).maybeSameAs->id, 4U);
  EXPECT_EQ(second.semantic.nextObjectId, 7U);
  EXPECT_EQ(second.semantic.cloud.at(5).points[0].object, 0U) << "none stays none";
  EXPECT_EQ(second.semantic.cloud.at(5).points[1].object, 6U);
  EXPECT_EQ(second.memory.objects.at(6).piece, 2U);
  EXPECT_EQ(second.memory.pairs.begin()->first, std::pair(4U, 6U));
  EXPECT_EQ(second.memory.tiles.at(5)[0].object, 6U);
  EXPECT_EQ(second.memory.tiles.at(5)[0].votes[1].object, 4U);
  EXPECT_EQ(second.memory.tiles.at(5)[0].votes[0].object, 0U);
}

}  // namespace
}  // namespace wardslam::merging
