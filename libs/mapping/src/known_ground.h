#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "free_fan.h"
#include "map_part.h"
#include "wardslam/core/ground_plane.h"
#include "wardslam/mapping/floor_finder.h"
#include "wardslam/mapping/map_builder.h"
#include "wardslam/mapping/view.h"
#include "wardslam/odometry/keyframe.h"

namespace wardslam::mapping {

/// Ground that another keyframe saw, as it should be under this one.
struct KnownGround {
  core::GroundPlane plane;
  double distance_m = 0.0;  ///< To that keyframe.
};

/// By the nearest keyframe of the same piece that saw the ground.
[[nodiscard]] std::optional<KnownGround> groundKnownAt(const std::map<odometry::KeyframeId, PlacedKeyframe>& keyframes,
                                                       const PlacedKeyframe& here);

/// Where nothing is known yet, up is where the map frame has it.
[[nodiscard]] GroundExpectation expectedAt(const PlacedKeyframe& here, const std::optional<KnownGround>& known);

/// Notes the ground that the keyframe's own image shows, unless the keyframe came with it. Returns what it stands on,
/// by that, else by what is known, else z = 0.
StandingGround lookAtGround(const View& view, const std::map<odometry::KeyframeId, PlacedKeyframe>& keyframes,
                            PlacedKeyframe& here);

/// Of the keyframes of one piece; not what became of its plan.
[[nodiscard]] FloorSeen floorSeenBy(const std::map<odometry::KeyframeId, PlacedKeyframe>& keyframes,
                                    std::optional<std::uint32_t> piece);

}  // namespace wardslam::mapping
