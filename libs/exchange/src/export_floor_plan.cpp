#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/serialization/CArchive.h>

#include "ros_map_files.h"
#include "wardslam/core/atomic_file.h"
#include "wardslam/core/errors.h"
#include "wardslam/exchange/map_export.h"
#include "wardslam/exchange/occupancy_grid.h"

namespace wardslam::exchange {
namespace {

using mapping::FloorPlan;

/// map_server's values.
unsigned char greyOf(unsigned char cell) {
  return cell == FloorPlan::kFree ? 254 : cell == FloorPlan::kOccupied ? 0 : 205;
}

}  // namespace

void exportGridmap(const mapping::SemanticMap& map, const std::filesystem::path& file) {
  const auto grid = toOccupancyGrid(floorPlanFor(map, file));
  core::replaceAtomically(file, [&grid](const std::filesystem::path& partial) {
    mrpt::io::CFileGZOutputStream out;
    if (!out.open(partial.string())) throw core::InputError(partial.string() + ": cannot be created");
    mrpt::serialization::archiveFrom(out) << grid;
  });
}

void exportRosMap(const mapping::SemanticMap& map, const std::filesystem::path& file) {
  const FloorPlan& plan = floorPlanFor(map, file);
  writeRosMap(
      plan, [&plan](int row, int column) { return greyOf(plan.cells.at<unsigned char>(row, column)); },
      "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n", file);
}

}  // namespace wardslam::exchange
