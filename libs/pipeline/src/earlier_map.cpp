#include "wardslam/pipeline/earlier_map.h"

#include <utility>

#include "wardslam/core/errors.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::pipeline {

EarlierMap readEarlierMap(const std::filesystem::path& file, graph::Saved use) {
  const auto map = storage::MapFile::open(file);
  EarlierMap earlier;
  earlier.use = use;
  earlier.semantic = map.read(use == graph::Saved::IsHeld ? storage::CloudPart::LeaveOut : storage::CloudPart::Include);
  earlier.graph.p_map_m = map.readPoints();
  for (odometry::Keyframe& keyframe : map.readViews()) {
    const auto placed = earlier.semantic.keyframes.find(keyframe.id);
    if (placed == earlier.semantic.keyframes.end()) continue;
    keyframe.T_map_cam = placed->second.T_map_cam;
    keyframe.submap = 0;
    earlier.graph.keyframes.push_back(std::make_shared<const odometry::Keyframe>(std::move(keyframe)));
  }
  if (earlier.graph.keyframes.empty()) {
    throw core::InputError(file.string() +
                           ": holds no keyframes to recognise places by; give a map that `wardslam run` has written");
  }
  return earlier;
}

}  // namespace wardslam::pipeline
