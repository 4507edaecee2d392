#pragma once

#include <mrpt/maps/TMetricMapTypesRegistry.h>

#include <memory>
#include <type_traits>

#include "wardslam/core/mrpt_compat.h"

/// Marks CMetricMap::boundingBox(), which MRPT 2.14 (Debian 13) knows and 2.5 (Debian 12) does not.
#if MRPT_VERSION >= WARDSLAM_MRPT_VERSION(2, 14, 0)
#define WARDSLAM_OVERRIDES_BOUNDING_BOX override
#else
#define WARDSLAM_OVERRIDES_BOUNDING_BOX
#endif

namespace wardslam::core {

/// What makes a map from its definition gives: a bare pointer in MRPT 2.5 (Debian 12), a shared one in 2.14 (Debian
/// 13).
using MapFromDefinition =
    std::invoke_result_t<mrpt::maps::internal::MapCtorFromDefFunctor, const mrpt::maps::TMetricMapInitializer&>;

/// A new map as MapFromDefinition, once `setUp` has done with it what the definition says.
template <class Map, class SetUp>
[[nodiscard]] MapFromDefinition makeMapFromDefinition(const SetUp& setUp) {
  if constexpr (std::is_pointer_v<MapFromDefinition>) {
    auto map = std::make_unique<Map>();
    setUp(*map);
    return map.release();
  } else {
    auto map = std::make_shared<Map>();
    setUp(*map);
    return map;
  }
}

}  // namespace wardslam::core
