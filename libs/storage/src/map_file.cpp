#include "wardslam/storage/map_file.h"

#include <SQLiteCpp/Backup.h>
#include <SQLiteCpp/SQLiteCpp.h>
#include <sqlite3.h>
#include <unistd.h>

#include "map_check.h"
#include "map_reading.h"
#include "map_schema.h"
#include "map_writing.h"
#include "wardslam/core/atomic_file.h"
#include "wardslam/core/blob.h"
#include "wardslam/core/errors.h"
#include "wardslam/mapping/floor_planner.h"

namespace wardslam::storage {
namespace {

namespace fs = std::filesystem;

std::string explain(const SQLite::Exception& error) {
  switch (error.getErrorCode()) {
    case SQLITE_NOTADB:
      return "is not a WardSLAM map";
    case SQLITE_CORRUPT:
      return std::string("is damaged or cut short (") + error.what() + "); take a copy of it";
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "is in use by another program; try again when that has ended";
    case SQLITE_READONLY:
      return "cannot be written; is it, or its folder, write-protected?";
    case SQLITE_CANTOPEN:
      return "cannot be opened; may you read it, and write in its folder?";
    case SQLITE_FULL:
    case SQLITE_IOERR:
      return std::string("cannot be read or written in full (") + error.what() + "); is the disk full?";
    default:
      return std::string("does not work as a map: ") + error.what();
  }
}

/// Runs `work`; what SQLite or a decoder throws becomes one sentence about the file.
template <class Work>
auto guarded(const fs::path& file, const Work& work) {
  try {
    return work();
  } catch (const SQLite::Exception& error) {
    const std::string sentence = file.string() + ": " + explain(error);
    if (error.getErrorCode() == SQLITE_BUSY) throw MapInUse(sentence);
    throw core::InputError(sentence);
  } catch (const core::BlobError& error) {
    throw core::InputError(file.string() + ": is damaged: " + error.what());
  }
}

void requireMap(SQLite::Database& database, const fs::path& file) {
  const int application = database.execAndGet("PRAGMA application_id");
  if (application != kApplicationId) {
    throw core::InputError(file.string() + ": is a database, but not a WardSLAM map");
  }
  const int version = database.execAndGet("PRAGMA user_version");
  if (version > schemaVersion()) {
    throw core::InputError(file.string() + ": was written by a newer WardSLAM (its schema has version " +
                           std::to_string(version) + ", this program knows " + std::to_string(schemaVersion()) +
                           "); use that one");
  }
}

void requireFile(const fs::path& file) {
  std::error_code error;
  const auto status = fs::status(file, error);
  if (!fs::exists(status)) throw core::InputError(file.string() + ": is not there; `wardslam run` writes maps");
  if (fs::is_directory(status)) throw core::InputError(file.string() + ": is a folder; name the .wardmap file in it");
  if (!fs::is_regular_file(status)) throw core::InputError(file.string() + ": is no file");
  if (fs::file_size(file, error) == 0) throw core::InputError(file.string() + ": is empty, so it is not a map");
}

fs::path partialOf(const fs::path& file) { return file.string() + ".partial"; }

/// What SQLite keeps beside the file.
void removeJournals(const fs::path& file) {
  for (const char* suffix : {"-journal", "-wal", "-shm"}) {
    std::error_code error;
    fs::remove(file.string() + suffix, error);
    if (error) throw core::InputError(file.string() + ": cannot be replaced: " + error.message());
  }
}

void removeDatabase(const fs::path& file) {
  removeJournals(file);
  std::error_code error;
  fs::remove(file, error);
  if (error) throw core::InputError(file.string() + ": cannot be replaced: " + error.message());
}

/// A rollback journal, not write-ahead logging: the map is this one file at every moment between two transactions,
/// also after the process was killed, and can be read from a write-protected medium.
void configure(SQLite::Database& database) {
  database.exec("PRAGMA foreign_keys = ON");
  database.exec("PRAGMA journal_mode = DELETE");
  database.exec("PRAGMA synchronous = EXTRA");  // the folder, too: a commit is one when the journal is gone
  database.exec("PRAGMA secure_delete = ON");   // what is erased may be of people: it is overwritten
  database.exec("PRAGMA temp_store = MEMORY");
  database.exec("PRAGMA trusted_schema = OFF");  // views and triggers that somebody else put there
}

/// Writable where permitted, also for readers: they may have to undo what a killed process left half written.
SQLite::Database connect(const fs::path& file) {
  const bool writable = ::access(file.c_str(), W_OK) == 0;
  return {file.string(), writable ? SQLite::OPEN_READWRITE : SQLite::OPEN_READONLY, MapFile::kPatience_ms};
}

fs::path journalOf(const fs::path& file) { return file.string() + "-journal"; }

/// One that is up to date, without writing into the file.
SQLite::Database connectUntouched(const fs::path& file) {
  if (fs::exists(journalOf(file))) {
    throw core::InputError(file.string() + ": its writer was interrupted; `wardslam map check " + file.string() +
                           "` takes back what was half written");
  }
  SQLite::Database source(file.string(), SQLite::OPEN_READONLY, MapFile::kPatience_ms);
  requireMap(source, file);
  if (int{source.execAndGet("PRAGMA user_version")} == schemaVersion()) return source;
  SQLite::Database upToDate(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  SQLite::Backup(upToDate, source).executeStep();
  migrateSchema(upToDate);
  return upToDate;
}

void commit(SQLite::Database& database, const MapChanges& changes) {
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  writeChanges(database, changes);
  transaction.commit();
}

/// Under a name of its own, so that `file` is a map as soon as it is there.
void makeDatabase(const fs::path& file, const MapHeader& header, const MapChanges* content) {
  if (fs::is_directory(file)) throw core::InputError(file.string() + ": is a folder");
  const fs::path partial = partialOf(file);
  removeDatabase(partial);
  guarded(file, [&] {
    SQLite::Database database(partial.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, MapFile::kPatience_ms);
    configure(database);
    migrateSchema(database);
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
    writeHeader(database, header);
    transaction.commit();
    // In a transaction of its own, as later changes are: SQLite counts them in the file.
    if (content) commit(database, *content);
  });
}

}  // namespace

struct MapFile::Connection {
  fs::path file;
  SQLite::Database database;

  /// Everything `work` reads belongs to one state of the file.
  template <class Work>
  auto reading(const Work& work) {
    return guarded(file, [&] {
      const SQLite::Transaction transaction(database);
      return work(database);
    });
  }
};

MapFile::MapFile(std::unique_ptr<Connection> connection) : connection_(std::move(connection)) {}
MapFile::~MapFile() = default;
MapFile::MapFile(MapFile&&) noexcept = default;
MapFile& MapFile::operator=(MapFile&&) noexcept = default;

void MapFile::requireThatOneCanBeMade(const fs::path& file) {
  makeDatabase(file, {}, nullptr);
  removeDatabase(partialOf(file));
}

MapFile MapFile::create(const fs::path& file, const MapHeader& header) { return createWith(file, header, nullptr); }

MapFile MapFile::create(const fs::path& file, const MapHeader& header, const MapChanges& content) {
  MapFile created = createWith(file, header, &content);
  if (!content.fusedPoints.empty()) created.remember(content.fusedPoints);
  return created;
}

MapFile MapFile::createWith(const fs::path& file, const MapHeader& header, const MapChanges* content) {
  makeDatabase(file, header, content);
  removeJournals(file);  // of the map that was there; they would be played back into the new one
  core::replaceFile(partialOf(file), file);
  return open(file, MapAccess::Write);
}

void MapFile::remember(const std::map<odometry::PointId, odometry::PointId>& fusedPoints) {
  MapChanges changes;
  changes.fusedPoints = fusedPoints;
  write(changes);
}

MapFile MapFile::open(const fs::path& file, MapAccess access) {
  requireFile(file);
  return guarded(file, [&] {
    const bool isUntouched = access == MapAccess::Untouched;
    auto connection =
        std::make_unique<Connection>(Connection{file, isUntouched ? connectUntouched(file) : connect(file)});
    SQLite::Database& database = connection->database;
    requireMap(database, file);
    configure(database);
    if (int{database.execAndGet("PRAGMA user_version")} < schemaVersion()) migrateSchema(database);
    if (access != MapAccess::Write) {
      database.exec("PRAGMA query_only = ON");
    } else if (sqlite3_db_readonly(database.getHandle(), "main") != 0) {
      throw core::InputError(file.string() + ": is write-protected");
    }
    return MapFile(std::move(connection));
  });
}

void MapFile::copy(const fs::path& from, const fs::path& to) {
  const MapFile source = open(from);
  removeDatabase(to);
  guarded(to, [&] {
    SQLite::Database target(to.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, kPatience_ms);
    SQLite::Backup(target, source.connection_->database).executeStep();
  });
}

void MapFile::write(const MapChanges& changes, int patience_ms) {
  guarded(connection_->file, [&] {
    connection_->database.setBusyTimeout(patience_ms);
    commit(connection_->database, changes);
  });
}

void MapFile::writeBeside(const MapChanges& changes) {
  const fs::path file = connection_->file;
  const fs::path partial = partialOf(file);
  removeDatabase(partial);
  guarded(file, [&] {
    connection_->database.setBusyTimeout(kPatience_ms);
    // Held until the copy has the name: nobody else may write into what is to be replaced.
    const SQLite::Transaction reserved(connection_->database, SQLite::TransactionBehavior::IMMEDIATE);
    {
      SQLite::Database source = connect(file);
      SQLite::Database copy(partial.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, kPatience_ms);
      SQLite::Backup(copy, source).executeStep();
      configure(copy);
      commit(copy, changes);
    }
    core::replaceFile(partial, file);
  });
  *this = open(file, MapAccess::Write);
}

void MapFile::compact() {
  const fs::path file = connection_->file;
  const fs::path partial = partialOf(file);
  removeDatabase(partial);
  try {
    guarded(file, [&] {
      connection_->database.setBusyTimeout(kPatience_ms);
      SQLite::Statement vacuum(connection_->database, "VACUUM INTO ?");
      vacuum.bind(1, partial.string());
      vacuum.exec();
    });
    core::syncToDisk(partial);
  } catch (const core::InputError&) {
    removeDatabase(partial);
    throw;
  }
  core::replaceFile(partial, file);
  *this = open(file, MapAccess::Write);
}

MapFileInfo MapFile::info() const {
  auto info = connection_->reading(readInfo);
  info.size_bytes = fs::file_size(connection_->file);
  return info;
}

MapHeader MapFile::header() const { return connection_->reading(readHeader); }

mapping::SemanticMap MapFile::read(CloudPart cloud, PiecePart pieces) const {
  return connection_->reading([=](SQLite::Database& database) { return readMap(database, cloud, pieces); });
}

mapping::SemanticMap MapFile::readWithFloorPlan(CloudPart cloud) const {
  auto map = read(cloud);
  if (map.floorPlan.cells.empty() && !map.keyframes.empty()) {
    map.floorPlan = mapping::drawFloorPlan(cloud == CloudPart::Include ? map : read(CloudPart::Include), {});
  }
  return map;
}

mapping::MapMemory MapFile::readMemory() const { return connection_->reading(storage::readMemory); }

std::map<mapping::ObjectId, mapping::ObjectMemory> MapFile::readObjectMemories() const {
  return connection_->reading(storage::readObjectMemories);
}

std::uint32_t MapFile::readFreeSubmap() const { return connection_->reading(storage::readFreeSubmap); }

std::vector<odometry::Keyframe> MapFile::readViews() const { return connection_->reading(storage::readViews); }

std::map<odometry::PointId, Eigen::Vector3d> MapFile::readPoints() const {
  return connection_->reading(storage::readPoints);
}

std::vector<LoopEdge> MapFile::readLoops() const { return connection_->reading(storage::readLoops); }

std::vector<std::string> MapFile::check() const { return connection_->reading(checkDatabase); }

MapChanges everythingOf(const mapping::SemanticMap& map) {
  MapChanges changes;
  changes.keyframes = map.keyframes;
  changes.cloud = map.cloud;
  for (const auto& [id, object] : map.objects) changes.objects.push_back(object);
  changes.zones = map.zones;
  changes.floorPlan = map.floorPlan;
  changes.nextObjectId = map.nextObjectId;
  return changes;
}

}  // namespace wardslam::storage
