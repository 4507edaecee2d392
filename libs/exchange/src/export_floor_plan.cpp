#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/serialization/CArchive.h>

#include <iomanip>
#include <sstream>

#include "wardslam/core/atomic_file.h"
#include "wardslam/core/errors.h"
#include "wardslam/exchange/map_export.h"
#include "wardslam/exchange/occupancy_grid.h"

namespace wardslam::exchange {
namespace {

using mapping::FloorPlan;

const FloorPlan& planOf(const mapping::SemanticMap& map, const std::filesystem::path& file) {
  if (!map.floorPlan.cells.empty()) return map.floorPlan;
  throw core::InputError(file.string() + ": the map has no floor plan to be written there");
}

/// A binary PGM with map_server's values; its first row is the farthest along y.
std::string pgmOf(const FloorPlan& plan) {
  constexpr char kFree = static_cast<char>(254);
  constexpr char kOccupied = 0;
  constexpr char kUnknown = static_cast<char>(205);
  std::string pgm = "P5\n" + std::to_string(plan.cells.cols) + " " + std::to_string(plan.cells.rows) + "\n255\n";
  for (int row = plan.cells.rows - 1; row >= 0; --row) {
    for (int column = 0; column < plan.cells.cols; ++column) {
      const auto cell = plan.cells.at<unsigned char>(row, column);
      pgm += cell == FloorPlan::kFree ? kFree : cell == FloorPlan::kOccupied ? kOccupied : kUnknown;
    }
  }
  return pgm;
}

std::string rosYaml(const FloorPlan& plan, const std::string& image) {
  std::ostringstream yaml;
  yaml << std::setprecision(12) << "image: \"" << image << "\"\nresolution: " << plan.resolution_m << "\norigin: ["
       << plan.origin_m.x() << ", " << plan.origin_m.y()
       << ", 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
  return yaml.str();
}

}  // namespace

void exportGridmap(const mapping::SemanticMap& map, const std::filesystem::path& file) {
  const auto grid = toOccupancyGrid(planOf(map, file));
  core::replaceAtomically(file, [&grid](const std::filesystem::path& partial) {
    mrpt::io::CFileGZOutputStream out;
    if (!out.open(partial.string())) throw core::InputError(partial.string() + ": cannot be created");
    mrpt::serialization::archiveFrom(out) << grid;
  });
}

void exportRosMap(const mapping::SemanticMap& map, const std::filesystem::path& file) {
  const FloorPlan& plan = planOf(map, file);
  std::filesystem::path image = file;
  image.replace_extension(".pgm");
  if (image == file) throw core::InputError(file.string() + ": name the .yaml file; the .pgm goes beside it");
  core::writeFileAtomically(image, pgmOf(plan));
  core::writeFileAtomically(file, rosYaml(plan, image.filename().string()));
}

}  // namespace wardslam::exchange
