#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>

#include "map_part.h"
#include "wardslam/odometry/keyframe.h"
#include "wardslam/odometry/map_update.h"

namespace wardslam::mapping {

using PlacedKeyframes = std::map<odometry::KeyframeId, PlacedKeyframe>;

/// As the keyframe graph places it: by the one before, where the map has that in the same frame.
[[nodiscard]] Eigen::Isometry3d placeOf(const odometry::Keyframe& keyframe, std::uint32_t piece,
                                        const PlacedKeyframes& keyframes);

/// The poses the update names, and those of keyframes that it does not know yet.
[[nodiscard]] std::map<odometry::KeyframeId, Eigen::Isometry3d> withYounger(const odometry::MapUpdate& update,
                                                                            const PlacedKeyframes& keyframes);

/// Of the newest keyframe of a piece (s); 0: it has none.
[[nodiscard]] double lastStampOf(std::uint32_t piece, const PlacedKeyframes& keyframes);

}  // namespace wardslam::mapping
