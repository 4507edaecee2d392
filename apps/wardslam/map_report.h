#pragma once

#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "wardslam/query/map_difference.h"
#include "wardslam/query/map_query.h"
#include "wardslam/storage/map_file.h"

/// What is known of a map, as JSON and as tables. Lengths in metres, in the map frame.
namespace wardslam::apps {

using Objects = std::vector<const mapping::MapObject*>;

[[nodiscard]] nlohmann::ordered_json toJson(const storage::MapFileInfo& info, const mapping::FloorPlan& plan);
[[nodiscard]] nlohmann::ordered_json toJson(const mapping::MapObject& object, const core::LabelSpace& labels);
[[nodiscard]] nlohmann::ordered_json toJson(const Objects& objects, const core::LabelSpace& labels);
[[nodiscard]] nlohmann::ordered_json toJson(const query::Place& place, const core::LabelSpace& labels);
[[nodiscard]] nlohmann::ordered_json toJson(const query::MapDifference& difference, const core::LabelSpace& labels);
[[nodiscard]] nlohmann::ordered_json zonesJson(const mapping::SemanticMap& map, const query::MapQuery& query);

void print(std::ostream& out, const storage::MapFileInfo& info, const mapping::FloorPlan& plan);
void print(std::ostream& out, const Objects& objects, const core::LabelSpace& labels);
void print(std::ostream& out, const query::Place& place, const core::LabelSpace& labels);
void print(std::ostream& out, const query::MapDifference& difference, const core::LabelSpace& labels);
void printZones(std::ostream& out, const mapping::SemanticMap& map, const query::MapQuery& query);

}  // namespace wardslam::apps
