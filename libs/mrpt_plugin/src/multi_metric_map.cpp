#include "wardslam/mrpt_plugin/multi_metric_map.h"

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/maps/CColouredOctoMap.h>
#include <mrpt/maps/CColouredPointsMap.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/COctoMap.h>
#include <mrpt/serialization/CArchive.h>

#include <exception>
#include <memory>

#include "wardslam/core/atomic_file.h"
#include "wardslam/core/errors.h"
#include "wardslam/exchange/metric_maps.h"
#include "wardslam/exchange/occupancy_grid.h"
#include "wardslam/mrpt_plugin/register_all.h"
#include "wardslam/mrpt_plugin/semantic_metric_map.h"

namespace wardslam::mrpt_plugin {

mrpt::maps::CMultiMetricMap toMetricMaps(const mapping::SemanticMap& map, const MetricMapChoice& choice) {
  mrpt::maps::CMultiMetricMap all;
  if (choice.semantic) all.maps.push_back(std::make_shared<CSemanticMap>(map));
  if (choice.points) all.maps.push_back(exchange::toColouredPoints(map));
  if (choice.grid && !map.floorPlan.cells.empty()) {
    all.maps.push_back(std::make_shared<mrpt::maps::COccupancyGridMap2D>(exchange::toOccupancyGrid(map.floorPlan)));
  }
  if (choice.octoMap) all.maps.push_back(exchange::toOctoMap(map, choice.octoMapResolution_m));
  if (choice.colouredOctoMap) all.maps.push_back(exchange::toColouredOctoMap(map, choice.octoMapResolution_m));
  return all;
}

void exportMetricMaps(const mapping::SemanticMap& map, const std::filesystem::path& file,
                      const MetricMapChoice& choice) {
  const auto all = toMetricMaps(map, choice);
  core::replaceAtomically(file, [&all](const std::filesystem::path& partial) {
    mrpt::io::CFileGZOutputStream out;
    if (!out.open(partial.string())) throw core::InputError(partial.string() + ": cannot be written");
    mrpt::serialization::archiveFrom(out) << all;
  });
}

mrpt::maps::CMultiMetricMap readMetricMaps(const std::filesystem::path& file) {
  registerAll();
  mrpt::io::CFileGZInputStream in;
  if (!std::filesystem::is_regular_file(file) || !in.open(file.string()))
    throw core::InputError(file.string() + ": cannot be opened for reading");
  try {
    mrpt::maps::CMultiMetricMap all;
    mrpt::serialization::archiveFrom(in) >> all;
    return all;
  } catch (const std::exception&) {
    throw core::InputError(file.string() + ": holds no CMultiMetricMap, or is damaged");
  }
}

}  // namespace wardslam::mrpt_plugin
