#pragma once

#include <vector>

#include "wardslam/pipeline/earlier_map.h"

namespace wardslam::merging {

/// Gives every piece, keyframe, point and thing of the maps a number that none of the others has, in the order of the
/// maps: keyframes and points without gaps from 1; pieces likewise, first those that are the maps.
void renumber(const std::vector<pipeline::EarlierMap*>& maps);

}  // namespace wardslam::merging
