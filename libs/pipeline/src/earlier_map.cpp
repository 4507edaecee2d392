#include "wardslam/pipeline/earlier_map.h"

#include <algorithm>
#include <utility>

#include "wardslam/core/errors.h"

namespace wardslam::pipeline {

EarlierMap readEarlierMap(const std::filesystem::path& file, graph::Saved use, storage::MapAccess access) {
  const auto map = storage::MapFile::open(file, access);
  EarlierMap earlier;
  const bool isHeld = use == graph::Saved::IsHeld;  // a camera finds itself in the map alone
  earlier.use = use;
  earlier.semantic = map.read(isHeld ? storage::CloudPart::LeaveOut : storage::CloudPart::Include,
                              isHeld ? storage::PiecePart::TheMap : storage::PiecePart::All);
  if (!isHeld) earlier.memory = map.readMemory();
  earlier.graph.map = earlier.semantic.piece;
  earlier.graph.freeSubmap = map.readFreeSubmap();
  earlier.graph.p_map_m = map.readPoints();
  for (odometry::Keyframe& keyframe : map.readViews()) {
    const auto placed = earlier.semantic.keyframes.find(keyframe.id);
    if (placed == earlier.semantic.keyframes.end()) continue;
    keyframe.T_map_cam = placed->second.T_map_cam;
    keyframe.ground = placed->second.ground;
    earlier.graph.keyframes.push_back(std::make_shared<const odometry::Keyframe>(std::move(keyframe)));
  }
  for (const auto& loop : map.readLoops()) {
    graph::Loop& tie = earlier.graph.loops.emplace_back();
    tie.older = loop.from;
    tie.newer = loop.to;
    tie.T_older_newer = loop.T_from_to;
    tie.inliers = loop.inliers;
  }
  if (earlier.graph.keyframes.empty()) {
    throw core::InputError(file.string() +
                           ": holds no keyframes to recognise places by; give a map that `wardslam run` has written");
  }
  return earlier;
}

}  // namespace wardslam::pipeline
