#include "wardslam/fleet/push.h"

#include <chrono>
#include <thread>

#include "map_rows_writing.h"
#include "map_snapshot.h"
#include "session.h"

namespace wardslam::fleet {
namespace {

/// The row of a map, which nobody else changes until the transaction ends.
struct LockedMap {
  std::int64_t id = 0;
  std::int64_t storey = 0;
  std::int64_t parent = 0;  ///< 0: none.
  double last_s = 0.0;
  std::string digest;  ///< Empty: nothing was pushed yet.
};

std::int64_t robotNamed(pqxx::transaction_base& transaction, const std::string& name) {
  execute(transaction, "INSERT INTO robots (name) VALUES ($1) ON CONFLICT DO NOTHING", name);
  return execute(transaction, "SELECT id FROM robots WHERE name = $1", name)[0][0].as<std::int64_t>();
}

std::int64_t storeyNamed(pqxx::transaction_base& transaction, const MapIdentity& identity) {
  execute(transaction, "INSERT INTO storeys (site, name) VALUES ($1, $2) ON CONFLICT DO NOTHING", identity.site,
          identity.storey);
  return execute(transaction, "SELECT id FROM storeys WHERE site = $1 AND name = $2", identity.site,
                 identity.storey)[0][0]
      .as<std::int64_t>();
}

LockedMap lockMap(pqxx::transaction_base& transaction, const MapIdentity& identity) {
  const auto robot = robotNamed(transaction, identity.robot);
  const auto storey = storeyNamed(transaction, identity);
  execute(transaction, "INSERT INTO maps (robot, name, storey) VALUES ($1, $2, $3) ON CONFLICT DO NOTHING", robot,
          identity.name, storey);
  const auto row = execute(transaction,
                           "SELECT maps.id, storey, coalesce(parent, 0), last_s, digest, storeys.site, storeys.name "
                           "FROM maps JOIN storeys ON storeys.id = storey WHERE robot = $1 AND maps.name = $2 "
                           "FOR UPDATE OF maps",
                           robot, identity.name)[0];
  if (row[1].as<std::int64_t>() != storey) {
    throw core::InputError("map '" + identity.name + "' of robot '" + identity.robot + "' is of site '" +
                           row[5].as<std::string>() + "', storey '" + row[6].as<std::string>() +
                           "' in the database; give this one another --name, or that site and storey");
  }
  return {row[0].as<std::int64_t>(), storey, row[2].as<std::int64_t>(), row[3].as<double>(), row[4].as<std::string>()};
}

/// Keyframes, of which those that two maps have in common show that one goes on from the other.
std::string keyframesOf(const MapSnapshot& snapshot) {
  Json rows = Json::array();
  for (const auto& [number, keyframe] : snapshot.map().keyframes) {
    rows.push_back({{"number", number}, {"stamp_s", keyframe.stamp_s}});
  }
  return parameterOf(rows);
}

void requireSameMap(pqxx::transaction_base& transaction, const LockedMap& map, const MapSnapshot& snapshot,
                    const MapIdentity& identity) {
  if (snapshot.map().keyframes.empty()) return;
  const auto row = execute(transaction,
                           "SELECT count(*), count(n.number) FROM keyframes k LEFT JOIN json_to_recordset($2::json) AS "
                           "n(number bigint, stamp_s float8) ON n.number = k.number AND n.stamp_s = k.stamp_s "
                           "WHERE k.map = $1",
                           map.id, keyframesOf(snapshot))[0];
  if (row[0].as<int>() == 0 || row[1].as<int>() > 0) return;
  throw core::InputError("another map of robot '" + identity.robot + "' has the name '" + identity.name +
                         "' in the database; give this one a --name of its own");
}

/// The map of the storey that has most keyframes in common with this new one; 0: none.
std::int64_t parentOf(pqxx::transaction_base& transaction, const LockedMap& map, const MapSnapshot& snapshot) {
  const auto rows = execute(transaction,
                            "SELECT k.map FROM maps JOIN keyframes k ON k.map = maps.id "
                            "JOIN json_to_recordset($3::json) AS n(number bigint, stamp_s float8) "
                            "ON n.number = k.number AND n.stamp_s = k.stamp_s "
                            "WHERE maps.storey = $2 AND maps.id <> $1 GROUP BY k.map ORDER BY count(*) DESC, k.map "
                            "LIMIT 1",
                            map.id, map.storey, keyframesOf(snapshot));
  return rows.empty() ? 0 : rows[0][0].as<std::int64_t>();
}

void setPose(pqxx::transaction_base& transaction, std::int64_t map, const Eigen::Isometry3d& T_storey_map) {
  const Eigen::Vector3d t_m = T_storey_map.translation();
  const Eigen::Quaterniond q(T_storey_map.linear());
  execute(transaction, "UPDATE maps SET x_m = $2, y_m = $3, z_m = $4, qx = $5, qy = $6, qz = $7, qw = $8 WHERE id = $1",
          map, t_m.x(), t_m.y(), t_m.z(), q.x(), q.y(), q.z(), q.w());
}

/// Of a map that is there for the first time: whom it goes on from, and how it lies in its storey.
void introduce(pqxx::transaction_base& transaction, LockedMap& map, const MapSnapshot& snapshot) {
  map.parent = parentOf(transaction, map, snapshot);
  if (map.parent != 0) {
    execute(transaction,
            "UPDATE maps SET parent = p.id, x_m = p.x_m, y_m = p.y_m, z_m = p.z_m, qx = p.qx, qy = p.qy, qz = p.qz, "
            "qw = p.qw FROM maps p WHERE maps.id = $1 AND p.id = $2",
            map.id, map.parent);
    return;
  }
  const auto first = execute(transaction, "SELECT min(id) = $1 FROM maps WHERE storey = $2", map.id, map.storey);
  if (first[0][0].as<bool>()) setPose(transaction, map.id, Eigen::Isometry3d::Identity());
}

PushReport writeMap(pqxx::transaction_base& transaction, const LockedMap& map, const MapSnapshot& snapshot) {
  PushReport report;
  const auto stays = findStays(transaction, map.id, snapshot);
  writeLabels(transaction, map.id, snapshot.map().labels);
  writeZones(transaction, map.id, snapshot.map().zones);
  writeFloorPlan(transaction, map.id, snapshot.map().floorPlan);
  writeRooms(transaction, map.id, snapshot.rooms());
  report.keyframes = writeKeyframes(transaction, map.id, snapshot.map().keyframes);
  report.objects = writeObjects(transaction, map.id, map.parent, snapshot.map().objects);
  writeStays(transaction, map.id, stays);
  makeFile(transaction, map.id, snapshot.digests());
  execute(transaction,
          "UPDATE maps SET first_s = $2, last_s = $3, digest = $4, size_bytes = $5, pushed_at = clock_timestamp() "
          "WHERE id = $1",
          map.id, snapshot.firstStamp_s(), snapshot.lastStamp_s(), snapshot.digests().whole,
          snapshot.digests().size_bytes);
  const auto push = execute(transaction, "INSERT INTO pushes (map, digest) VALUES ($1, $2) RETURNING id", map.id,
                            snapshot.digests().whole)[0][0]
                        .as<std::int64_t>();
  writeChanges(transaction, map.id, push, stays.changes);
  report.changes = stays.changes.size();
  execute(transaction, "SELECT pg_notify($1, $2)", kPushChannel, std::to_string(push));
  return report;
}

PushReport pushOnce(pqxx::transaction_base& transaction, const MapIdentity& identity, const MapSnapshot& snapshot,
                    const PushOptions& options) {
  LockedMap map = lockMap(transaction, identity);
  const bool isNew = map.digest.empty();
  if (!isNew) requireSameMap(transaction, map, snapshot, identity);
  if (isNew) introduce(transaction, map, snapshot);
  if (options.T_storey_map) setPose(transaction, map.id, *options.T_storey_map);
  PushReport report;
  if (map.digest == snapshot.digests().whole) {
    report.outcome = PushReport::Outcome::WasThere;
  } else if (snapshot.lastStamp_s() < map.last_s) {
    report.outcome = PushReport::Outcome::NewerIsThere;
  } else {
    report = writeMap(transaction, map, snapshot);
  }
  return report;
}

/// Whether the database wants the file, before anything is sent.
bool isWanted(pqxx::transaction_base& transaction, const MapIdentity& identity, const MapSnapshot& snapshot) {
  const auto rows = execute(transaction,
                            "SELECT maps.id, last_s, digest FROM maps JOIN robots ON robots.id = robot "
                            "WHERE robots.name = $1 AND maps.name = $2",
                            identity.robot, identity.name);
  if (rows.empty()) return true;
  LockedMap map;
  map.id = rows[0][0].as<std::int64_t>();
  requireSameMap(transaction, map, snapshot, identity);
  return rows[0][2].as<std::string>() != snapshot.digests().whole && rows[0][1].as<double>() <= snapshot.lastStamp_s();
}

/// The pieces of the file go ahead.
void sendAhead(const std::string& url, const MapIdentity& identity, const MapSnapshot& snapshot,
               const std::function<void(std::uint64_t)>& onSent) {
  auto connection = connectTo(url);
  guarded(url, [&] {
    {
      pqxx::work transaction(connection);
      enterSchema(transaction, url);
      if (!isWanted(transaction, identity, snapshot)) return;
    }
    sendChunks(connection, snapshot.copy(), snapshot.digests(), onSent);
  });
}

using Clock = std::chrono::steady_clock;

/// Goes on trying what broke off on the way; what cannot work from the start is told at once.
class Patience {
 public:
  explicit Patience(const PushOptions& options) : options_(options) {}

  /// What is sent stays: it may take as long again.
  void hasSent() { deadline_.reset(); }

  /// Of the exception that is being handled; returns to try again.
  void wait(const core::InputError& error, bool brokeOff) {
    hasBegun_ = hasBegun_ || brokeOff;
    if (!hasBegun_) throw;
    const auto now = Clock::now();
    if (!deadline_)
      deadline_ = now + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options_.patience_s));
    if (now >= *deadline_ || options_.isInterrupted()) throw;
    if (brokeOff) options_.note(error.what());
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
  }

 private:
  const PushOptions& options_;
  bool hasBegun_ = false;
  std::optional<Clock::time_point> deadline_;
};

}  // namespace

PushReport push(const std::string& url, const MapIdentity& identity, const std::filesystem::path& file,
                const PushOptions& options) {
  const MapSnapshot snapshot(file);
  Patience patience(options);
  std::uint64_t sent_bytes = 0;
  const auto onSent = [&](std::uint64_t bytes) {
    sent_bytes += bytes;
    patience.hasSent();
    if (options.isInterrupted())
      throw core::InputError("interrupted; what was sent stays, the next push goes on there");
  };
  while (true) {
    try {
      sendAhead(url, identity, snapshot, onSent);
      auto report = inTransaction(url, Isolation::Committed, [&](pqxx::transaction_base& transaction) {
        return pushOnce(transaction, identity, snapshot, options);
      });
      report.file_bytes = sent_bytes;
      return report;
    } catch (const ConnectionLost& error) {
      patience.wait(error, true);
    } catch (const CannotConnect& error) {
      patience.wait(error, false);
    }
  }
}

}  // namespace wardslam::fleet
