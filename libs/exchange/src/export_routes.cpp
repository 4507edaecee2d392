#include <yaml-cpp/yaml.h>

#include <nlohmann/json.hpp>

#include "wardslam/core/atomic_file.h"
#include "wardslam/exchange/fleet_export.h"

namespace wardslam::exchange {
namespace {

using Json = nlohmann::ordered_json;
using building::Lane;
using building::RouteNetwork;
using building::Waypoint;

Json nodeOf(const Waypoint& waypoint, std::size_t id) {
  Json properties = {{"id", id}, {"frame", "map"}};
  if (!waypoint.name.empty()) properties["metadata"] = {{"name", waypoint.name}};
  return {{"type", "Feature"},
          {"geometry", {{"type", "Point"}, {"coordinates", {waypoint.p_map_m.x(), waypoint.p_map_m.y()}}}},
          {"properties", properties}};
}

/// Nodes and edges share their numbers. No cost is told: the route server goes by the length.
Json edgeOf(const Lane& lane, std::size_t id, const RouteNetwork& network) {
  const auto at = [&network](std::size_t index) -> Json {
    const auto& p_m = network.waypoints.at(index).p_map_m;
    return {p_m.x(), p_m.y()};
  };
  Json properties = {{"id", id}, {"startid", lane.from}, {"endid", lane.to}};
  if (lane.maxSpeed_mps > 0.0) properties["metadata"] = {{"abs_speed_limit", lane.maxSpeed_mps}};
  const Json line = Json::array({at(lane.from), at(lane.to)});
  return {{"type", "Feature"},
          {"geometry", {{"type", "MultiLineString"}, {"coordinates", Json::array({line})}}},
          {"properties", properties}};
}

YAML::Node vertexOf(const Waypoint& waypoint) {
  YAML::Node options(YAML::NodeType::Map);
  options["name"] = waypoint.name;
  YAML::Node vertex;
  vertex.SetStyle(YAML::EmitterStyle::Flow);
  vertex.push_back(waypoint.p_map_m.x());
  vertex.push_back(waypoint.p_map_m.y());
  vertex.push_back(options);
  return vertex;
}

YAML::Node laneOf(const Lane& lane) {
  YAML::Node options(YAML::NodeType::Map);
  if (lane.maxSpeed_mps > 0.0) options["speed_limit"] = lane.maxSpeed_mps;
  YAML::Node yaml;
  yaml.SetStyle(YAML::EmitterStyle::Flow);
  yaml.push_back(lane.from);
  yaml.push_back(lane.to);
  yaml.push_back(options);
  return yaml;
}

}  // namespace

void exportNav2Route(const RouteNetwork& network, const std::filesystem::path& file) {
  Json features = Json::array();
  for (std::size_t i = 0; i < network.waypoints.size(); ++i) features.push_back(nodeOf(network.waypoints[i], i));
  for (std::size_t i = 0; i < network.lanes.size(); ++i)
    features.push_back(edgeOf(network.lanes[i], network.waypoints.size() + i, network));
  const Json graph = {{"type", "FeatureCollection"}, {"name", "graph"}, {"features", features}};
  core::writeFileAtomically(file, graph.dump(1) + "\n");
}

void exportRmfGraph(const RouteNetwork& network, const std::string& level, const std::filesystem::path& file) {
  YAML::Node vertices(YAML::NodeType::Sequence);
  YAML::Node lanes(YAML::NodeType::Sequence);
  for (const Waypoint& waypoint : network.waypoints) vertices.push_back(vertexOf(waypoint));
  for (const Lane& lane : network.lanes) lanes.push_back(laneOf(lane));
  YAML::Node graph;
  graph["building_name"] = level;
  graph["lifts"] = YAML::Node(YAML::NodeType::Map);
  graph["levels"][level]["lanes"] = lanes;
  graph["levels"][level]["vertices"] = vertices;
  YAML::Emitter out;
  out.SetDoublePrecision(9);
  out << graph;
  core::writeFileAtomically(file, std::string(out.c_str()) + "\n");
}

}  // namespace wardslam::exchange
