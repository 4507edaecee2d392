#include "stored_map.h"

#include "wardslam/mapping/floor_planner.h"

namespace wardslam::apps {

mapping::SemanticMap readStoredMap(const std::filesystem::path& file, storage::CloudPart cloud) {
  const auto stored = storage::MapFile::open(file);
  auto map = stored.read(cloud);
  if (map.floorPlan.cells.empty() && !map.keyframes.empty()) {
    map.floorPlan = mapping::drawFloorPlan(stored.read(storage::CloudPart::Include), {});
  }
  return map;
}

}  // namespace wardslam::apps
