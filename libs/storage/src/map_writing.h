#pragma once

#include <SQLiteCpp/Database.h>

#include "wardslam/storage/map_file.h"

namespace wardslam::storage {

void writeHeader(SQLite::Database& database, const MapHeader& header);

/// Within the caller's transaction.
void writeChanges(SQLite::Database& database, const MapChanges& changes);

}  // namespace wardslam::storage
