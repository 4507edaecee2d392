#include "map_check.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <set>

#include "map_reading.h"
#include "wardslam/core/blob.h"

namespace wardslam::storage {
namespace {

using Problems = std::vector<std::string>;

/// What the database itself finds: pages, indices, references between tables.
void checkPages(SQLite::Database& database, Problems& problems) {
  SQLite::Statement integrity(database, "PRAGMA integrity_check(20)");
  while (integrity.executeStep()) {
    const std::string finding = integrity.getColumn(0);
    if (finding != "ok") problems.push_back("integrity: " + finding);
  }
  SQLite::Statement references(database, "PRAGMA foreign_key_check");
  while (references.executeStep()) {
    problems.push_back("a row of " + references.getColumn(0).getString() + " refers to a missing row of " +
                       references.getColumn(2).getString());
  }
}

/// `sql` counts rows that should not be there.
void checkNone(SQLite::Database& database, const char* sql, const char* complaint, Problems& problems) {
  const std::int64_t found = database.execAndGet(sql).getInt64();
  if (found > 0) problems.push_back(std::to_string(found) + " " + complaint);
}

/// References that SQLite does not follow for us.
void checkReferences(SQLite::Database& database, Problems& problems) {
  checkNone(database, "SELECT count(*) FROM objects WHERE class_id NOT IN (SELECT class_id FROM labels)",
            "objects are of a class without a name", problems);
  checkNone(database,
            "SELECT count(*) FROM objects o LEFT JOIN object_boxes b ON b.id = o.id WHERE b.id IS NULL "
            "OR b.min_x_m > o.min_x_m OR b.max_x_m < o.max_x_m OR b.min_y_m > o.min_y_m OR b.max_y_m < o.max_y_m "
            "OR b.min_z_m > o.min_z_m OR b.max_z_m < o.max_z_m",
            "objects are missing in the index of boxes, or lie elsewhere in it", problems);
  checkNone(database, "SELECT count(*) FROM object_boxes WHERE id NOT IN (SELECT id FROM objects)",
            "boxes in the index belong to no object", problems);
  checkNone(database,
            "SELECT count(*) FROM (SELECT zone FROM objects UNION ALL SELECT zone FROM keyframes) "
            "WHERE zone <> '' AND zone NOT IN (SELECT name FROM zones)",
            "objects or keyframes lie in a zone that is not defined", problems);
  checkNone(database, "SELECT count(*) FROM points WHERE id NOT IN (SELECT point FROM sightings)",
            "tracking points are seen by no keyframe", problems);
  checkNone(database, "SELECT count(*) FROM views WHERE typeof(stretch) <> 'integer' OR stretch < 0",
            "keyframes belong to an impossible stretch of tracking", problems);
}

/// Decodes everything.
void checkContents(SQLite::Database& database, Problems& problems) {
  const auto attempt = [&problems](const auto& read) {
    try {
      read();
    } catch (const core::BlobError& error) {
      problems.emplace_back(error.what());
    }
  };
  attempt([&] { (void)readViews(database); });
  attempt([&] { (void)readPoints(database); });
  attempt([&] { (void)readLoops(database); });
  attempt([&] {
    const auto map = readMap(database, CloudPart::Include);
    std::size_t unowned = 0;
    for (const auto& [keyframe, tile] : map.cloud) {
      for (const auto& point : tile.points) {
        if (point.object != 0 && map.objects.count(point.object) == 0) ++unowned;
      }
    }
    if (unowned > 0) problems.push_back(std::to_string(unowned) + " points of the cloud belong to a missing object");
  });
}

}  // namespace

std::vector<std::string> checkDatabase(SQLite::Database& database) {
  Problems problems;
  checkPages(database, problems);
  if (!problems.empty()) return problems;  // what follows would only repeat it
  checkReferences(database, problems);
  checkContents(database, problems);
  return problems;
}

}  // namespace wardslam::storage
