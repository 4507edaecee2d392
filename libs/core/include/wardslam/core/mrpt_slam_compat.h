#pragma once

#include <mrpt/slam/CMetricMapBuilder.h>

#include <type_traits>
#include <utility>

#include "wardslam/core/mrpt_compat.h"

namespace wardslam::core {

/// What mrpt::slam::CMetricMapBuilder::getCurrentlyBuiltMetricMap() gives: a pointer in MRPT 2.5 (Debian 12), a
/// reference in 2.14 (Debian 13).
using BuiltMetricMap = decltype(std::declval<const mrpt::slam::CMetricMapBuilder&>().getCurrentlyBuiltMetricMap());

/// A map as BuiltMetricMap, and the way back.
template <class Built = BuiltMetricMap>
[[nodiscard]] Built asBuiltMetricMap(const mrpt::maps::CMultiMetricMap& map) {
  if constexpr (std::is_pointer_v<Built>) {
    return &map;
  } else {
    return map;
  }
}
[[nodiscard]] inline const mrpt::maps::CMultiMetricMap& metricMapOf(const mrpt::maps::CMultiMetricMap* built) {
  return *built;
}
[[nodiscard]] inline const mrpt::maps::CMultiMetricMap& metricMapOf(const mrpt::maps::CMultiMetricMap& built) {
  return built;
}

}  // namespace wardslam::core
