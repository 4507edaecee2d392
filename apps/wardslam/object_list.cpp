#include "object_list.h"

#include <nlohmann/json.hpp>

#include "map_report.h"
#include "wardslam/core/atomic_file.h"

namespace wardslam::apps {

void writeObjects(const std::filesystem::path& file, const mapping::SemanticMap& map) {
  Objects objects;
  for (const auto& [id, object] : map.objects) objects.push_back(&object);
  core::writeFileAtomically(file, toJson(objects, map.labels).dump(2) + "\n");
}

}  // namespace wardslam::apps
