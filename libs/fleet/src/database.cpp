#include "wardslam/fleet/database.h"

#include <algorithm>
#include <regex>

#include "migrations.h"
#include "session.h"

namespace wardslam::fleet {
namespace {

/// So that several programs that prepare one database do so one after the other.
constexpr long kMigrationLock = 0x57445346;

/// Of what libpq or the server said, on one line.
std::string onOneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
  text = std::regex_replace(text, std::regex(" +"), " ");
  const auto last = text.find_last_not_of(" .");
  return last == std::string::npos ? std::string() : text.substr(0, last + 1);
}

bool contains(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

std::string adviceFor(const std::string& said) {
  if (contains(said, "password") || contains(said, "authentication"))
    return "check the user, and the password in $PGPASSWORD or ~/.pgpass";
  if (contains(said, "database \"") && contains(said, "does not exist")) return "make it with createdb";
  return "is the server running, and is --database right?";
}

bool hasSchema(pqxx::transaction_base& transaction) {
  return execute(transaction, "SELECT to_regclass('wardslam.migrations') IS NOT NULL")[0][0].as<bool>();
}

int storedVersion(pqxx::transaction_base& transaction) {
  if (!hasSchema(transaction)) return 0;
  return execute(transaction, "SELECT coalesce(max(version), 0) FROM wardslam.migrations")[0][0].as<int>();
}

void setSearchPath(pqxx::transaction_base& transaction) {
  execute(transaction, "SET LOCAL search_path = wardslam, public");
}

void requirePostgis(pqxx::transaction_base& transaction, const std::string& url) {
  const auto found = execute(transaction,
                             "SELECT (SELECT count(*) FROM pg_extension WHERE extname = 'postgis'),"
                             "(SELECT count(*) FROM pg_available_extensions WHERE name = 'postgis')")[0];
  if (found[0].as<int>() > 0) return;
  if (found[1].as<int>() == 0) {
    throw core::InputError(withoutPassword(url) +
                           ": the server has no PostGIS; install it there (Debian: postgresql-postgis), then again");
  }
  try {
    execute(transaction, "CREATE EXTENSION postgis SCHEMA public");
  } catch (const pqxx::insufficient_privilege&) {
    throw core::InputError(withoutPassword(url) +
                           ": PostGIS is not in this database; have its administrator run CREATE EXTENSION postgis");
  }
}

void requireNotNewer(int version, const std::string& url) {
  if (version <= schemaVersion()) return;
  throw core::InputError(withoutPassword(url) + ": its schema has version " + std::to_string(version) +
                         ", this program knows " + std::to_string(schemaVersion()) + "; use a newer WardSLAM");
}

/// Returns the version before; one step at most.
int takeStep(pqxx::connection& connection, const std::string& url) {
  pqxx::work transaction(connection);
  execute(transaction, "SELECT pg_advisory_xact_lock($1)", kMigrationLock);
  const int version = storedVersion(transaction);
  requireNotNewer(version, url);
  if (version == schemaVersion()) return version;
  if (version == 0) {
    requirePostgis(transaction, url);
    execute(transaction, "CREATE SCHEMA IF NOT EXISTS wardslam");
    execute(transaction,
            "CREATE TABLE IF NOT EXISTS wardslam.migrations (version integer PRIMARY KEY, name text NOT NULL, "
            "applied_at timestamptz NOT NULL DEFAULT clock_timestamp())");
  }
  setSearchPath(transaction);
  const Migration& step = migrations().at(static_cast<std::size_t>(version));
  transaction.exec(step.sql);
  execute(transaction, "INSERT INTO migrations (version, name) VALUES ($1, $2)", version + 1, step.name);
  transaction.commit();
  return version;
}

}  // namespace

int schemaVersion() { return static_cast<int>(migrations().size()); }

SchemaSteps prepareDatabase(const std::string& url) {
  auto connection = connectTo(url);
  return guarded(url, [&] {
    const int before = takeStep(connection, url);
    while (takeStep(connection, url) < schemaVersion()) {
    }
    return SchemaSteps{before, schemaVersion()};
  });
}

std::string withoutPassword(const std::string& url) {
  const std::string hidden = std::regex_replace(url, std::regex("(://[^/:@]*):[^/]*@"), "$1@");
  return std::regex_replace(hidden, std::regex("password=('[^']*'|[^& ]*)"), "password=...");
}

pqxx::connection connectTo(const std::string& url) {
  try {
    return pqxx::connection(url);
  } catch (const pqxx::failure& error) {
    const std::string said = onOneLine(error.what());
    if (contains(said, "the database system is"))
      throw ConnectionLost(withoutPassword(url) + ": the server is starting or going down; try again");
    throw CannotConnect(withoutPassword(url) + ": cannot connect (" + said + "); " + adviceFor(said));
  }
}

void enterSchema(pqxx::transaction_base& transaction, const std::string& url) {
  const int version = storedVersion(transaction);
  requireNotNewer(version, url);
  if (version < schemaVersion()) {
    throw core::InputError(withoutPassword(url) +
                           (version == 0 ? ": has no tables of WardSLAM yet"
                                         : ": its schema has version " + std::to_string(version) +
                                               ", this program needs " + std::to_string(schemaVersion())) +
                           "; run wardslam fleet init");
  }
  setSearchPath(transaction);
}

void rethrowAsSentence(const std::string& url) {
  const std::string where = withoutPassword(url) + ": ";
  try {
    throw;
  } catch (const pqxx::insufficient_privilege& error) {
    throw core::InputError(where + "this user may not do that (" + onOneLine(error.what()) +
                           "); have the administrator GRANT wardslam_robot or wardslam_reader to it");
  } catch (const pqxx::broken_connection& error) {
    throw ConnectionLost(where + "the connection broke off (" + onOneLine(error.what()) + "); try again");
  } catch (const pqxx::in_doubt_error& error) {
    throw ConnectionLost(where + "the connection broke off in the end (" + onOneLine(error.what()) + "); try again");
  } catch (const pqxx::transaction_rollback& error) {
    throw ConnectionLost(where + "others were in the way (" + onOneLine(error.what()) + "); try again");
  } catch (const pqxx::foreign_key_violation& error) {  // pieces that another push had no more use for
    throw ConnectionLost(where + "others were in the way (" + onOneLine(error.what()) + "); try again");
  } catch (const pqxx::sql_error& error) {
    const bool isClosing = error.sqlstate().substr(0, 3) == "57P";
    if (isClosing) throw ConnectionLost(where + "the server is going down; try again");
    throw core::InputError(where + "the database refuses (" + onOneLine(error.what()) + ")");
  } catch (const pqxx::failure& error) {
    throw core::InputError(where + "the database is not understood (" + onOneLine(error.what()) + ")");
  }
}

}  // namespace wardslam::fleet
