#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "pqxx_compat.h"
#include "sighting_intervals.h"
#include "wardslam/building/rooms.h"
#include "wardslam/mapping/semantic_map.h"

/// Rows of the tables. Those that go there travel as JSON, all of a table as one parameter.
namespace wardslam::fleet {

using Json = nlohmann::json;

/// `rows`: list of rows as the parameter of json_to_recordset().
[[nodiscard]] std::string parameterOf(const Json& rows);

/// "{1,2,3}", a parameter of type bigint[].
[[nodiscard]] std::string arrayOf(const std::vector<std::uint64_t>& numbers);

/// With a digest of what they say.
[[nodiscard]] Json rowOf(std::uint64_t number, const mapping::MappedKeyframe& keyframe, int run);
[[nodiscard]] Json rowOf(const mapping::MapObject& object);

[[nodiscard]] Json rowOf(const building::Room& room);

[[nodiscard]] Json rowOf(mapping::ObjectId object, const Stay& stay);

/// Names of classes that have one.
[[nodiscard]] std::map<int, std::string> namesOf(const core::LabelSpace& labels);

[[nodiscard]] core::LabelSpace readLabels(pqxx::transaction_base& transaction, std::int64_t map);
[[nodiscard]] std::map<std::uint64_t, mapping::MappedKeyframe> readKeyframes(pqxx::transaction_base& transaction,
                                                                             std::int64_t map);
[[nodiscard]] std::map<mapping::ObjectId, mapping::MapObject> readObjects(pqxx::transaction_base& transaction,
                                                                          std::int64_t map);
[[nodiscard]] std::vector<mapping::Zone> readZones(pqxx::transaction_base& transaction, std::int64_t map);
[[nodiscard]] mapping::FloorPlan readFloorPlan(pqxx::transaction_base& transaction, std::int64_t map);

/// The last stay of each thing.
[[nodiscard]] std::map<mapping::ObjectId, Stay> readLastStays(pqxx::transaction_base& transaction, std::int64_t map);

}  // namespace wardslam::fleet
