#pragma once

#include <SQLiteCpp/Database.h>

#include <string>
#include <vector>

namespace wardslam::storage {

/// One sentence for each thing that is wrong; empty for a sound file.
[[nodiscard]] std::vector<std::string> checkDatabase(SQLite::Database& database);

}  // namespace wardslam::storage
