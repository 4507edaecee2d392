#include "stored_map.h"

namespace wardslam::apps {

mapping::SemanticMap readStoredMap(const std::filesystem::path& file, storage::CloudPart cloud) {
  return storage::MapFile::open(file).readWithFloorPlan(cloud);
}

}  // namespace wardslam::apps
