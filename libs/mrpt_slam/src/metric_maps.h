#pragma once

#include <mrpt/maps/CMultiMetricMap.h>

#include "wardslam/mapping/semantic_map.h"

namespace wardslam::mrpt_slam {

/// The metric maps that are asked for, of a map of WardSLAM's: a CSemanticMap is that map, a CColouredPointsMap its
/// cloud in its colours; all others are made by MRPT of its simple map (exchange::toSimpleMap()), with the options they
/// have in the definitions. Without definitions: a CSemanticMap.
[[nodiscard]] mrpt::maps::CMultiMetricMap makeMetricMaps(const mrpt::maps::TSetOfMetricMapInitializers& definitions,
                                                         const mapping::SemanticMap& map);

}  // namespace wardslam::mrpt_slam
