#pragma once

#include <mrpt/maps/CSimpleMap.h>

#include "wardslam/mapping/semantic_map.h"

namespace wardslam::exchange {

/// Of a keyframe's pose, in m and in rad: a round figure, as graph.pose_graph has it.
inline constexpr double kKeyframePoseSigma = 0.02;

/// The map as MRPT's programs make maps from (observations2map, CMetricMap::loadFromSimpleMap()): one entry per
/// keyframe, in order. Its pose is where the camera is, upright, x ahead (a camera may be tilted; MRPT's grids take no
/// scan that is tilted against its robot), and observed was
///
/// - CObservation3DRangeScan "RGBD": the part of the cloud that hangs on the keyframe, as points, without images;
/// - CObservation2DRangeScan "RGBD_SCAN": what a laser scanner that looks all around would see there by the floor plan,
///   of the directions in which something stands behind floor that is known to be free; one scan for every run of such.
[[nodiscard]] mrpt::maps::CSimpleMap toSimpleMap(const mapping::SemanticMap& map);

}  // namespace wardslam::exchange
