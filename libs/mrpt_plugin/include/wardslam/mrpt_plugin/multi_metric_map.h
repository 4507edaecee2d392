#pragma once

#include <mrpt/maps/CMultiMetricMap.h>

#include <filesystem>

#include "wardslam/mapping/semantic_map.h"

namespace wardslam::mrpt_plugin {

/// Which of MRPT's maps are wanted.
struct MetricMapChoice {
  bool semantic = true;          ///< CSemanticMap
  bool points = true;            ///< CColouredPointsMap: the cloud
  bool grid = true;              ///< COccupancyGridMap2D: the floor plan, where there is one
  bool octoMap = true;           ///< COctoMap
  bool colouredOctoMap = false;  ///< CColouredOctoMap
  double octoMapResolution_m = 0.05;
};

/// A map of WardSLAM's, of a `.wardmap` (storage::MapFile) or a run (SlamSystem::semanticMap()), as MRPT's metric maps,
/// in the order above.
[[nodiscard]] mrpt::maps::CMultiMetricMap toMetricMaps(const mapping::SemanticMap& map,
                                                       const MetricMapChoice& choice = {});

/// The same as one file, gzipped: one CMultiMetricMap as MRPT serialises it. Throws core::InputError when it cannot be
/// written.
void exportMetricMaps(const mapping::SemanticMap& map, const std::filesystem::path& file,
                      const MetricMapChoice& choice = {});

/// The way back. Throws core::InputError for a file that is none, or damaged.
[[nodiscard]] mrpt::maps::CMultiMetricMap readMetricMaps(const std::filesystem::path& file);

}  // namespace wardslam::mrpt_plugin
