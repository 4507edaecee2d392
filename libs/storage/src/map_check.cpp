#include "map_check.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <string>
#include <vector>

#include "map_reading.h"
#include "map_rows.h"
#include "wardslam/core/blob.h"
#include "wardslam/core/errors.h"
#include "wardslam/mapping/zones.h"

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

/// Nothing a map holds, in whatever unit, is larger.
constexpr const char* kLargest = "1e12";

struct Column {
  std::string table;
  std::string name;
  std::string type;
};

std::vector<Column> columnsOf(SQLite::Database& database) {
  SQLite::Statement find(database,
                         "SELECT m.name, c.name, c.type FROM sqlite_master m, pragma_table_info(m.name) c "
                         "WHERE m.type = 'table' AND m.name NOT LIKE 'object_boxes%' ORDER BY m.name, c.cid");
  std::vector<Column> columns;
  while (find.executeStep()) columns.push_back({find.getColumn(0), find.getColumn(1), find.getColumn(2)});
  return columns;
}

/// A name as SQL, whatever is in it: other programs may have made tables of their own.
std::string quoted(const std::string& name) {
  std::string sql = "\"";
  for (const char letter : name) sql += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return sql + '"';
}

/// What a value of the column must be, as SQL: what other programs write need not be what the column is for.
std::string conditionOn(const Column& column) {
  const std::string name = quoted(column.name);
  if (column.type == "INTEGER") {
    return "typeof(" + name + ") = 'integer' AND " + name + " BETWEEN 0 AND " + std::to_string(kHighestId);
  }
  if (column.type == "REAL") {
    return "typeof(" + name + ") IN ('real', 'integer') AND abs(" + name + ") <= " + kLargest;
  }
  if (column.type == "TEXT") return "typeof(" + name + ") = 'text'";
  if (column.type == "BLOB") return "typeof(" + name + ") = 'blob'";
  return "1";  // properties: each is of its own kind
}

/// Every column of every table, also of those that nobody reads.
void checkTypes(SQLite::Database& database, Problems& problems) {
  for (const Column& column : columnsOf(database)) {
    const std::string sql = "SELECT count(*) FROM " + quoted(column.table) + " WHERE NOT (" + conditionOn(column) + ")";
    const std::int64_t found = database.execAndGet(sql).getInt64();
    if (found > 0) {
      problems.push_back("in " + std::to_string(found) + " rows of " + column.table + " the " + column.name +
                         " is impossible");
    }
  }
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
  checkNone(database,
            "SELECT count(*) FROM properties WHERE name = 'map_piece' AND (typeof(value) <> 'integer' OR "
            "(value NOT IN (SELECT piece FROM keyframes) AND EXISTS (SELECT 1 FROM keyframes)))",
            "map_piece is the number of no piece", problems);
  checkNone(database, "SELECT count(*) FROM objects WHERE piece NOT IN (SELECT piece FROM keyframes)",
            "objects are of a piece without keyframes", problems);
  checkNone(database,
            "SELECT count(*) FROM (SELECT stretch FROM views JOIN keyframes ON id = keyframe GROUP BY stretch "
            "HAVING count(DISTINCT piece) > 1)",
            "stretches of tracking lie in several pieces", problems);
  checkNone(database,
            "SELECT count(*) FROM object_hints WHERE maybe_same_as = object OR maybe_same_as NOT IN "
            "(SELECT id FROM objects UNION SELECT object FROM object_memories) AND maybe_same_as >= "
            "(SELECT value FROM properties WHERE name = 'next_object_id')",
            "hints are about objects that never were", problems);
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
    } catch (const core::InputError& error) {
      problems.emplace_back(error.what());
    }
  };
  attempt([&] { (void)readViews(database); });
  attempt([&] { (void)readPoints(database); });
  attempt([&] { (void)readLoops(database); });
  attempt([&] { (void)readMemory(database); });
  attempt([&] { (void)readFreeSubmap(database); });
  attempt([&] {
    const auto map = readMap(database, CloudPart::Include, PiecePart::All);
    static_cast<void>(mapping::Zones(map.zones));
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
  checkTypes(database, problems);
  checkReferences(database, problems);
  checkContents(database, problems);
  return problems;
}

}  // namespace wardslam::storage
