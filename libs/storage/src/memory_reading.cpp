#include <SQLiteCpp/SQLiteCpp.h>

#include "blob_codecs.h"
#include "map_reading.h"
#include "map_rows.h"

namespace wardslam::storage {
namespace {

constexpr std::uint8_t kNo = 0;
constexpr std::uint8_t kYes = 1;

void readTileMemories(SQLite::Database& database, mapping::MapMemory& memory) {
  forEachRow(database, "memory of the tile of keyframe", "SELECT keyframe, points FROM tile_memories ORDER BY keyframe",
             [&memory](ColumnReader row) {
               odometry::KeyframeId keyframe = 0;
               core::Bytes blob;
               row >> keyframe >> blob;
               memory.tiles.emplace(keyframe, decodeTileMemory(blob));
             });
}

void readObjectMemories(SQLite::Database& database, mapping::MapMemory& memory) {
  forEachRow(
      database, "memory of object",
      "SELECT object, views, expected, missed, first_seen_s, last_seen_s, last_x_m, last_y_m, last_z_m, handled_s, "
      "views_to_rest, erased, gone_s, place_was_empty, state, piece FROM object_memories ORDER BY object",
      [&memory](ColumnReader row) {
        mapping::ObjectId id = 0;
        mapping::ObjectMemory object;
        Eigen::Vector3d place_m;
        std::uint64_t erased = 0;
        std::uint8_t wasEmpty = 0;
        std::string state;
        row >> idIn(id) >> countIn(object.views) >> countIn(object.expected) >> countIn(object.missed) >>
            stampIn(object.firstSeen_s) >> stampIn(object.lastSeen_s) >> place_m >> stampIn(object.handled_s) >>
            countIn(object.viewsToRest) >> idIn(erased) >> stampIn(object.gone_s) >> within(wasEmpty, kNo, kYes) >>
            state >> pieceIn(object.piece);
        object.lastPlace_m = place_m.cast<float>();
        object.erased = static_cast<std::size_t>(erased);
        object.placeWasEmpty = wasEmpty != 0;
        object.state = objectState(state);
        memory.objects.emplace(id, object);
      });
  forEachRow(database, "votes for object", "SELECT object, class_id, confidence FROM object_votes",
             [&memory](ColumnReader row) {
               mapping::ObjectId id = 0;
               core::ClassId classId = 0;
               double confidence = 0.0;
               row >> id >> classId >> within(confidence, 0.0, 1e12);
               const auto object = memory.objects.find(id);
               if (object == memory.objects.end()) throw core::BlobError("nothing else is remembered of it");
               object->second.votes[classId] = confidence;
             });
  forEachRow(database, "pair of object", "SELECT object, other, together, apart FROM object_pairs",
             [&memory](ColumnReader row) {
               std::pair<mapping::ObjectId, mapping::ObjectId> ids;
               mapping::PairMemory pair;
               row >> idIn(ids.first) >> idIn(ids.second) >> countIn(pair.together) >> countIn(pair.apart);
               if (ids.first >= ids.second) throw core::BlobError("the lesser number comes first");
               memory.pairs.emplace(ids, pair);
             });
}

}  // namespace

std::map<mapping::ObjectId, mapping::ObjectMemory> readObjectMemories(SQLite::Database& database) {
  mapping::MapMemory memory;
  readObjectMemories(database, memory);
  return std::move(memory.objects);
}

mapping::MapMemory readMemory(SQLite::Database& database) {
  mapping::MapMemory memory;
  readTileMemories(database, memory);
  readObjectMemories(database, memory);
  return memory;
}

}  // namespace wardslam::storage
