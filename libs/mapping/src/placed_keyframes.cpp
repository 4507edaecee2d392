#include "placed_keyframes.h"

#include <algorithm>
#include <iterator>

namespace wardslam::mapping {

Eigen::Isometry3d placeOf(const odometry::Keyframe& keyframe, std::uint32_t piece, const PlacedKeyframes& keyframes) {
  const auto previous = keyframes.find(keyframe.id - 1);
  const bool follows = keyframe.T_previous_cam && previous != keyframes.end() && previous->second.piece == piece;
  return follows ? previous->second.T_map_cam * *keyframe.T_previous_cam : keyframe.T_map_cam;
}

std::map<odometry::KeyframeId, Eigen::Isometry3d> withYounger(const odometry::MapUpdate& update,
                                                              const PlacedKeyframes& keyframes) {
  auto T_map_cam = update.T_map_cam;
  const auto newest = keyframes.find(update.newestKeyframe);
  if (newest == keyframes.end()) return T_map_cam;
  const Eigen::Isometry3d correction = odometry::correctionOf(update, newest->second.T_map_cam);
  for (auto younger = std::next(newest); younger != keyframes.end(); ++younger) {
    const auto& [id, keyframe] = *younger;
    if (keyframe.piece == newest->second.piece) T_map_cam.try_emplace(id, correction * keyframe.T_map_cam);
  }
  return T_map_cam;
}

double lastStampOf(std::uint32_t piece, const PlacedKeyframes& keyframes) {
  double last_s = 0.0;
  for (const auto& [id, keyframe] : keyframes) {
    if (keyframe.piece == piece) last_s = std::max(last_s, keyframe.stamp_s);
  }
  return last_s;
}

}  // namespace wardslam::mapping
