#include "object_list.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "wardslam/core/atomic_file.h"

namespace wardslam::apps {
namespace {

using Json = nlohmann::ordered_json;

/// To a tenth of a millimetre.
double rounded(double value) { return std::round(value * 1e4) / 1e4; }

Json toJson(const Eigen::Vector3d& v) { return {rounded(v.x()), rounded(v.y()), rounded(v.z())}; }

const char* nameOf(mapping::ObjectState state) {
  switch (state) {
    case mapping::ObjectState::Static:
      return "static";
    case mapping::ObjectState::Moved:
      return "moved";
    case mapping::ObjectState::Gone:
      return "gone";
  }
  return "";
}

Json toJson(const mapping::OrientedBox& box) {
  const Eigen::Vector3d axis = box.T_map_box.linear().col(0);
  return {{"center", toJson(box.T_map_box.translation())},
          {"size", toJson(box.size_m)},
          {"yaw_rad", rounded(std::atan2(axis.y(), axis.x()))}};
}

Json toJson(const mapping::MapObject& object, const core::LabelSpace& labels) {
  Json json;
  json["id"] = object.id;
  json["class_id"] = object.classId;
  json["class_name"] = labels.name(object.classId);
  json["centroid"] = toJson(object.centroid_m);
  json["box_min"] = toJson(object.box_m.min());
  json["box_max"] = toJson(object.box_m.max());
  json["oriented_box"] = toJson(object.orientedBox);
  json["probability"] = rounded(object.probability);
  json["views"] = object.views;
  json["zone"] = object.zone;
  json["state"] = nameOf(object.state);
  json["first_seen"] = object.firstSeen_s;
  json["last_seen"] = object.lastSeen_s;
  return json;
}

}  // namespace

void writeObjects(const std::filesystem::path& file, const mapping::SemanticMap& map) {
  Json json;
  json["objects"] = Json::array();
  for (const auto& [id, object] : map.objects) json["objects"].push_back(toJson(object, map.labels));
  core::writeFileAtomically(file, json.dump(2) + "\n");
}

}  // namespace wardslam::apps
