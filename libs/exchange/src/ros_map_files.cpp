#include "ros_map_files.h"

#include <iomanip>
#include <sstream>

#include "wardslam/core/atomic_file.h"
#include "wardslam/core/errors.h"

namespace wardslam::exchange {

const mapping::FloorPlan& floorPlanFor(const mapping::SemanticMap& map, const std::filesystem::path& file) {
  if (!map.floorPlan.cells.empty()) return map.floorPlan;
  throw core::InputError(file.string() + ": the map has no floor plan to be written there");
}

void writeRosMap(const mapping::FloorPlan& plan, const std::function<unsigned char(int row, int column)>& valueAt,
                 const std::string& rules, const std::filesystem::path& file) {
  std::filesystem::path image = file;
  image.replace_extension(".pgm");
  if (image == file) throw core::InputError(file.string() + ": name the .yaml file; the .pgm goes beside it");
  std::string pgm = "P5\n" + std::to_string(plan.cells.cols) + " " + std::to_string(plan.cells.rows) + "\n255\n";
  for (int row = plan.cells.rows - 1; row >= 0; --row) {
    for (int column = 0; column < plan.cells.cols; ++column) pgm += static_cast<char>(valueAt(row, column));
  }
  std::ostringstream yaml;
  yaml << std::setprecision(12) << "image: \"" << image.filename().string() << "\"\nresolution: " << plan.resolution_m
       << "\norigin: [" << plan.origin_m.x() << ", " << plan.origin_m.y() << ", 0.0]\n"
       << rules;
  core::writeFileAtomically(image, pgm);
  core::writeFileAtomically(file, yaml.str());
}

}  // namespace wardslam::exchange
