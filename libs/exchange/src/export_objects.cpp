#include <iomanip>
#include <nlohmann/json.hpp>
#include <ostream>

#include "polygons.h"
#include "wardslam/core/atomic_file.h"
#include "wardslam/exchange/map_export.h"

namespace wardslam::exchange {
namespace {

using Json = nlohmann::ordered_json;

Json ringOf(const std::vector<Eigen::Vector2d>& corners_m) {
  Json ring = Json::array();
  for (const auto& corner : closedRing(corners_m)) ring.push_back({corner.x(), corner.y()});
  return ring;
}

Json featureOf(const std::vector<Eigen::Vector2d>& polygon_m, const Json& properties) {
  return {{"type", "Feature"},
          {"geometry", {{"type", "Polygon"}, {"coordinates", Json::array({ringOf(polygon_m)})}}},
          {"properties", properties}};
}

Json featureOf(const mapping::MapObject& object, const core::LabelSpace& labels) {
  return featureOf(footprintOf(object), {{"kind", "object"},
                                         {"id", object.id},
                                         {"class_id", object.classId},
                                         {"class_name", labels.name(object.classId)},
                                         {"probability", object.probability},
                                         {"bottom", object.box_m.min().z()},
                                         {"top", object.box_m.max().z()},
                                         {"views", object.views},
                                         {"zone", object.zone},
                                         {"state", toString(object.state)}});
}

/// Quoted as RFC 4180 wants it where needed.
std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

void writeCsvRow(std::ostream& out, const mapping::MapObject& object, const core::LabelSpace& labels) {
  out << object.id << ',' << int{object.classId} << ',' << csvField(labels.name(object.classId));
  out << std::fixed << std::setprecision(4);
  for (const Eigen::Vector3d& p_m : {object.centroid_m, object.box_m.min(), object.box_m.max()}) {
    for (const double coordinate : p_m) out << ',' << coordinate;
  }
  out << ',' << object.probability << ',' << object.views << ',' << object.firstSeen_s << ',' << object.lastSeen_s
      << ',' << csvField(object.zone) << ',' << toString(object.state) << '\n';
}

}  // namespace

void exportGeoJson(const mapping::SemanticMap& map, const std::filesystem::path& file) {
  Json features = Json::array();
  for (const auto& zone : map.zones) {
    features.push_back(featureOf(zone.polygon_m, {{"kind", "zone"}, {"name", zone.name}}));
  }
  for (const auto& [id, object] : map.objects) {
    if (object.state != mapping::ObjectState::Gone) features.push_back(featureOf(object, map.labels));
  }
  const Json collection = {{"type", "FeatureCollection"}, {"frame", "map"}, {"unit", "m"}, {"features", features}};
  core::writeFileAtomically(file, collection.dump(1) + "\n");
}

void exportCsv(const mapping::SemanticMap& map, const std::filesystem::path& file) {
  core::AtomicFile out(file);
  out.stream() << "id,class_id,class_name,centroid_x,centroid_y,centroid_z,min_x,min_y,min_z,max_x,max_y,max_z,"
                  "probability,views,first_seen,last_seen,zone,state\n";
  for (const auto& [id, object] : map.objects) writeCsvRow(out.stream(), object, map.labels);
  out.commit();
}

}  // namespace wardslam::exchange
