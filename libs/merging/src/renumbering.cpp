#include "renumbering.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace wardslam::merging {
namespace {

using graph::KeyframeId;
using graph::PointId;
using mapping::ObjectId;
using pipeline::EarlierMap;

template <class Value, class Number>
std::map<Number, Value> withNewKeys(std::map<Number, Value> values, const std::map<Number, Number>& numbers) {
  std::map<Number, Value> renumbered;
  for (auto& [number, value] : values) renumbered.emplace(numbers.at(number), std::move(value));
  return renumbered;
}

std::set<std::uint32_t> piecesOf(const EarlierMap& map) {
  std::set<std::uint32_t> pieces;
  for (const auto& [id, keyframe] : map.semantic.keyframes) pieces.insert(keyframe.piece);
  for (const auto& [id, object] : map.semantic.objects) pieces.insert(object.piece);
  for (const auto& [id, object] : map.memory.objects) pieces.insert(object.piece);
  return pieces;
}

ObjectId lastObjectOf(const EarlierMap& map) {
  ObjectId last = map.semantic.nextObjectId - 1;
  if (!map.semantic.objects.empty()) last = std::max(last, map.semantic.objects.rbegin()->first);
  if (!map.memory.objects.empty()) last = std::max(last, map.memory.objects.rbegin()->first);
  return last;
}

void renumberGraph(graph::SavedGraph& graph, const Numbers& numbers) {
  for (auto& shared : graph.keyframes) {
    auto keyframe = std::make_shared<odometry::Keyframe>(*shared);
    keyframe->id = numbers.keyframes.at(keyframe->id);
    keyframe->submap = numbers.pieces.at(keyframe->submap);
    for (odometry::Sighting& sighting : keyframe->sightings) sighting.point = numbers.points.at(sighting.point);
    shared = std::move(keyframe);
  }
  graph.p_map_m = withNewKeys(std::move(graph.p_map_m), numbers.points);
  for (graph::Loop& loop : graph.loops) {
    loop.older = numbers.keyframes.at(loop.older);
    loop.newer = numbers.keyframes.at(loop.newer);
  }
  graph.map = numbers.pieces.at(graph.map);
}

void renumberSemantic(mapping::SemanticMap& map, const Numbers& numbers) {
  map.piece = numbers.pieces.at(map.piece);
  map.keyframes = withNewKeys(std::move(map.keyframes), numbers.keyframes);
  for (auto& [id, keyframe] : map.keyframes) keyframe.piece = numbers.pieces.at(keyframe.piece);
  map.cloud = renumbered(std::move(map.cloud), numbers);
  std::map<ObjectId, mapping::MapObject> objects;
  for (auto& [id, object] : map.objects) {
    object.id = numbers.object(id);
    object.piece = numbers.pieces.at(object.piece);
    if (object.maybeSameAs) object.maybeSameAs->id = numbers.object(object.maybeSameAs->id);
    objects.emplace(object.id, std::move(object));
  }
  map.objects = std::move(objects);
  map.nextObjectId = numbers.object(map.nextObjectId);
}

void renumberMemory(mapping::MapMemory& memory, const Numbers& numbers) {
  memory.tiles = renumbered(std::move(memory.tiles), numbers);
  std::map<ObjectId, mapping::ObjectMemory> objects;
  for (auto& [id, object] : memory.objects) {
    object.piece = numbers.pieces.at(object.piece);
    objects.emplace(numbers.object(id), std::move(object));
  }
  memory.objects = std::move(objects);
  std::map<std::pair<ObjectId, ObjectId>, mapping::PairMemory> pairs;
  for (const auto& [ids, pair] : memory.pairs) pairs[{numbers.object(ids.first), numbers.object(ids.second)}] = pair;
  memory.pairs = std::move(pairs);
}

}  // namespace

ShownTiles renumbered(ShownTiles tiles, const Numbers& numbers) {
  tiles = withNewKeys(std::move(tiles), numbers.keyframes);
  for (auto& [id, tile] : tiles) {
    for (auto& point : tile.points) point.object = numbers.object(point.object);
  }
  return tiles;
}

TileMemories renumbered(TileMemories tiles, const Numbers& numbers) {
  tiles = withNewKeys(std::move(tiles), numbers.keyframes);
  for (auto& [id, tile] : tiles) {
    for (mapping::PointMemory& point : tile) {
      point.object = numbers.object(point.object);
      for (mapping::ObjectVote& vote : point.votes) vote.object = numbers.object(vote.object);
    }
  }
  return tiles;
}

std::vector<Numbers> renumber(const std::vector<EarlierMap*>& maps) {
  std::vector<Numbers> numbers(maps.size());
  std::uint32_t piece = 0;
  for (std::size_t i = 0; i < maps.size(); ++i) numbers[i].pieces[maps[i]->semantic.piece] = ++piece;
  KeyframeId keyframe = 0;
  PointId point = 0;
  ObjectId objects = 0;
  for (std::size_t i = 0; i < maps.size(); ++i) {
    for (const std::uint32_t other : piecesOf(*maps[i])) {
      if (numbers[i].pieces.emplace(other, piece + 1).second) ++piece;
    }
    for (const auto& [id, mapped] : maps[i]->semantic.keyframes) numbers[i].keyframes[id] = ++keyframe;
    for (const auto& [id, p_map_m] : maps[i]->graph.p_map_m) numbers[i].points[id] = ++point;
    numbers[i].objectsBefore = objects;
    objects += lastObjectOf(*maps[i]);
  }
  for (std::size_t i = 0; i < maps.size(); ++i) {
    renumberGraph(maps[i]->graph, numbers[i]);
    renumberSemantic(maps[i]->semantic, numbers[i]);
    renumberMemory(maps[i]->memory, numbers[i]);
    maps[i]->graph.freeSubmap = piece + 1;
  }
  return numbers;
}

}  // namespace wardslam::merging
