#pragma once

#include <SQLiteCpp/Database.h>

#include <vector>

#include "wardslam/mapping/zone.h"

namespace wardslam::storage {

/// In the order they were written in. Throws core::BlobError for what writeZones() does not write.
[[nodiscard]] std::vector<mapping::Zone> readZones(SQLite::Database& database);

/// In place of those that are there.
void writeZones(SQLite::Database& database, const std::vector<mapping::Zone>& zones);

}  // namespace wardslam::storage
