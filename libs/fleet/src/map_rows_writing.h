#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "map_rows.h"
#include "map_snapshot.h"

/// Has the database hold of a map what a snapshot does; sends what differs.
namespace wardslam::fleet {

void writeLabels(pqxx::transaction_base& transaction, std::int64_t map, const core::LabelSpace& labels);
void writeZones(pqxx::transaction_base& transaction, std::int64_t map, const std::vector<mapping::Zone>& zones);
void writeRooms(pqxx::transaction_base& transaction, std::int64_t map, const building::Rooms& rooms);
void writeFloorPlan(pqxx::transaction_base& transaction, std::int64_t map, const mapping::FloorPlan& plan);

/// And the runs that they make up. Returns how many were sent.
std::size_t writeKeyframes(pqxx::transaction_base& transaction, std::int64_t map,
                           const std::map<std::uint64_t, mapping::MappedKeyframe>& keyframes);

/// `parent`: the map this one goes on from; 0: none. Returns how many were sent.
std::size_t writeObjects(pqxx::transaction_base& transaction, std::int64_t map, std::int64_t parent,
                         const std::map<mapping::ObjectId, mapping::MapObject>& objects);

/// A thing that is new, moved, gone or back.
struct Change {
  mapping::ObjectId object = 0;
  std::string kind;
  double at_s = 0.0;
  Eigen::Vector3d place_m = Eigen::Vector3d::Zero();
  std::string zone;
  std::string zoneBefore;  ///< Of what moved or came back.
};

/// Where things stood, by what was known and the snapshot; before its keyframes are written, for places move with them.
struct StayChanges {
  Json last = Json::array();
  Json next = Json::array();
  std::vector<Change> changes;
};
[[nodiscard]] StayChanges findStays(pqxx::transaction_base& transaction, std::int64_t map, const MapSnapshot& snapshot);
void writeStays(pqxx::transaction_base& transaction, std::int64_t map, const StayChanges& stays);
void writeChanges(pqxx::transaction_base& transaction, std::int64_t map, std::int64_t push,
                  const std::vector<Change>& changes);

}  // namespace wardslam::fleet
