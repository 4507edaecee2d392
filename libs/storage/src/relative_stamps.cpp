#include "relative_stamps.h"

#include <algorithm>

namespace wardslam::storage {
namespace {

void makeRelative(double& stamp_s, double origin_s) {
  if (stamp_s != 0.0) stamp_s = std::max(0.0, stamp_s - origin_s);
}

}  // namespace

void makeStampsRelative(MapChanges& changes, double origin_s) {
  for (auto& [id, keyframe] : changes.keyframes) makeRelative(keyframe.stamp_s, origin_s);
  for (auto& object : changes.objects) {
    makeRelative(object.firstSeen_s, origin_s);
    makeRelative(object.lastSeen_s, origin_s);
  }
}

void makeStampsRelative(mapping::MapMemory& memory, double origin_s) {
  for (auto& [id, object] : memory.objects) {
    for (double* stamp_s : {&object.firstSeen_s, &object.lastSeen_s, &object.handled_s, &object.gone_s}) {
      makeRelative(*stamp_s, origin_s);
    }
  }
}

}  // namespace wardslam::storage
