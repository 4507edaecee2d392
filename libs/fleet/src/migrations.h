#pragma once

#include <vector>

namespace wardslam::fleet {

/// A step of the schema: migrations/NAME.sql.
struct Migration {
  const char* name;
  const char* sql;
};

/// The step at [i] leads from version i to i + 1.
[[nodiscard]] const std::vector<Migration>& migrations();

}  // namespace wardslam::fleet
