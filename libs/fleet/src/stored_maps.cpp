#include "wardslam/fleet/stored_maps.h"

#include "file_chunks.h"
#include "map_rows.h"
#include "session.h"

namespace wardslam::fleet {
namespace {

pqxx::result chosenMaps(pqxx::transaction_base& transaction, const MapChoice& choice) {
  return execute(transaction,
                 "SELECT maps.id, site, storeys.name, robots.name, maps.name, last_s, size_bytes, digest FROM maps "
                 "JOIN storeys ON storeys.id = storey JOIN robots ON robots.id = robot WHERE digest <> '' "
                 "AND ($1 = '' OR site = $1) AND ($2 = '' OR storeys.name = $2) AND ($3 = '' OR robots.name = $3) "
                 "AND ($4 = '' OR maps.name = $4) ORDER BY last_s DESC, maps.id",
                 choice.site, choice.storey, choice.robot, choice.name);
}

StoredMap mapOf(const pqxx::row& row) {
  return {row[0].as<std::int64_t>(), row[1].as<std::string>(), row[2].as<std::string>(),  row[3].as<std::string>(),
          row[4].as<std::string>(),  row[5].as<double>(),      row[6].as<std::uint64_t>()};
}

std::string wordsOf(const MapChoice& choice) {
  std::string words;
  for (const auto& [what, name] : {std::pair("site", choice.site), std::pair("storey", choice.storey),
                                   std::pair("robot", choice.robot), std::pair("map", choice.name)}) {
    if (!name.empty()) words += (words.empty() ? " of " : ", ") + std::string(what) + " '" + name + "'";
  }
  return words;
}

pqxx::row newestMap(pqxx::transaction_base& transaction, const std::string& url, const MapChoice& choice) {
  const auto rows = chosenMaps(transaction, choice);
  if (rows.empty()) {
    throw core::InputError(withoutPassword(url) + ": no map" + wordsOf(choice) +
                           " was pushed yet; wardslam fleet push does that");
  }
  return rows[0];
}

/// `read(transaction)`, all of it as at one moment, whoever pushes meanwhile.
template <class Read>
auto inOneMoment(const std::string& url, const Read& read) {
  return inTransaction(url, Isolation::OneMoment, read);
}

}  // namespace

std::vector<StoredMap> storedMaps(const std::string& url, const MapChoice& choice) {
  return inOneMoment(url, [&](pqxx::transaction_base& transaction) {
    std::vector<StoredMap> maps;
    for (const auto& row : chosenMaps(transaction, choice)) maps.push_back(mapOf(row));
    return maps;
  });
}

mapping::SemanticMap readNewestMap(const std::string& url, const MapChoice& choice) {
  return inOneMoment(url, [&](pqxx::transaction_base& transaction) {
    const auto id = newestMap(transaction, url, choice)[0].as<std::int64_t>();
    mapping::SemanticMap map;
    map.labels = readLabels(transaction, id);
    map.keyframes = readKeyframes(transaction, id);
    map.objects = readObjects(transaction, id);
    map.zones = readZones(transaction, id);
    map.floorPlan = readFloorPlan(transaction, id);
    return map;
  });
}

StoredMap pullNewestMap(const std::string& url, const MapChoice& choice, const std::filesystem::path& file) {
  return inOneMoment(url, [&](pqxx::transaction_base& transaction) {
    const auto row = newestMap(transaction, url, choice);
    StoredMap map = mapOf(row);
    fetchFile(transaction, map.id, row[7].as<std::string>(), file);
    return map;
  });
}

}  // namespace wardslam::fleet
