#pragma once

#include <string>

#include "wardslam/core/errors.h"

/// A hospital's database, PostgreSQL with PostGIS (docs/fleet.md). `url`: postgresql://USER@HOST:PORT/DATABASE, or what
/// else libpq takes. Who speaks to it throws core::InputError with one sentence: no server, no access, another schema.
namespace wardslam::fleet {

/// There is no server, no such database, or no access to it.
class CannotConnect : public core::InputError {
 public:
  using core::InputError::InputError;
};

/// The connection broke off on the way, or the server is starting: nothing is lost or half done, and doing it again is
/// all that is needed.
class ConnectionLost : public core::InputError {
 public:
  using core::InputError::InputError;
};

/// Of what this program reads and writes.
[[nodiscard]] int schemaVersion();

struct SchemaSteps {
  int before = 0;  ///< The version that was there; 0: none.
  int now = 0;
};

/// Makes the schema, or brings an older one up to date, step by step, each in a transaction; several programs may do so
/// at once. The user must be allowed to make schemas and roles, and PostGIS must be there or may be made.
[[nodiscard]] SchemaSteps prepareDatabase(const std::string& url);

/// The URL without the password, to be shown.
[[nodiscard]] std::string withoutPassword(const std::string& url);

}  // namespace wardslam::fleet
