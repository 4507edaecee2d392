#include "wardslam/fleet/watch.h"

#include <utility>

#include "session.h"

namespace wardslam::fleet {
namespace {

constexpr long kLook_us = 200000;

void tellChanges(pqxx::connection& connection, const std::string& url, const MapChoice& choice, const std::string& push,
                 const Watcher& watcher) {
  pqxx::work transaction(connection);
  enterSchema(transaction, url);
  const auto rows = execute(transaction,
                            "SELECT site, storeys.name, robots.name, maps.name, c.object, coalesce(labels.name, ''), "
                            "c.kind, c.at_s, ST_X(c.place), ST_Y(c.place), ST_Z(c.place), c.zone, "
                            "coalesce(room_at(c.map, c.place), ''), coalesce(c.zone_before, '') "
                            "FROM changes c JOIN maps ON maps.id = c.map JOIN storeys ON storeys.id = maps.storey "
                            "JOIN robots ON robots.id = maps.robot "
                            "JOIN objects o ON o.map = c.map AND o.number = c.object "
                            "LEFT JOIN labels ON labels.map = o.map AND labels.class_id = o.class_id "
                            "WHERE ($1 = '' OR site = $1) AND ($2 = '' OR storeys.name = $2) "
                            "AND ($3 = '' OR robots.name = $3) AND ($4 = '' OR maps.name = $4) AND c.push = $5 "
                            "ORDER BY c.at_s, c.object",
                            choice.site, choice.storey, choice.robot, choice.name, push);
  for (const auto& row : rows) {
    watcher.hear({row[0].as<std::string>(), row[1].as<std::string>(), row[2].as<std::string>(),
                  row[3].as<std::string>(), row[4].as<mapping::ObjectId>(), row[5].as<std::string>(),
                  row[6].as<std::string>(), row[7].as<double>(),
                  Eigen::Vector3d(row[8].as<double>(), row[9].as<double>(), row[10].as<double>()),
                  row[11].as<std::string>(), row[12].as<std::string>(), row[13].as<std::string>()});
  }
}

}  // namespace

void watch(const std::string& url, const MapChoice& choice, const Watcher& watcher) {
  auto connection = connectTo(url);
  guarded(url, [&] {
    tellChanges(connection, url, choice, "0", watcher);  // is it a database of ours?
    std::vector<std::string> pushes;
    const Listener listener(connection, kPushChannel, [&](const std::string& push) { pushes.push_back(push); });
    watcher.isReady();
    while (!watcher.isInterrupted()) {
      connection.await_notification(0, kLook_us);
      for (const auto& push : std::exchange(pushes, {})) tellChanges(connection, url, choice, push, watcher);
    }
  });
}

}  // namespace wardslam::fleet
