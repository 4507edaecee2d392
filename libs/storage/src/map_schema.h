#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>

/// The tables of a map file; docs/file_formats.md explains them.
namespace wardslam::storage {

constexpr std::int32_t kApplicationId = 0x5744534D;  ///< "WDSM", SQLite's application_id.

/// SQLite's user_version of files this program writes.
[[nodiscard]] int schemaVersion();

/// Takes the tables from the version they have (0: an empty database) to the newest, in one transaction.
void migrateSchema(SQLite::Database& database);

}  // namespace wardslam::storage
