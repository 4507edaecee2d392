#include "map_export_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "stored_map.h"
#include "support/program.h"
#include "wardslam/building/rooms_of_map.h"
#include "wardslam/core/errors.h"
#include "wardslam/exchange/fleet_export.h"
#include "wardslam/exchange/map_export.h"
#include "wardslam/exchange/tum_trajectory.h"
#include "wardslam/graph/pose_graph_file.h"
#include "wardslam/mrpt_plugin/multi_metric_map.h"
#include "wardslam/pipeline/earlier_map.h"
#include "wardslam/query/routes_through.h"
#include "wardslam/viewer/map_scene.h"

namespace wardslam::apps {
namespace {

using Path = std::filesystem::path;
using mapping::SemanticMap;

/// What is exported, and from where.
struct Source {
  Path file;
  Path poses;  ///< A `.graph` with other poses of the keyframes; empty = the map's own.
  mrpt_plugin::MetricMapChoice choice;
  double robotRadius_m;
  SemanticMap map;
};

struct Format {
  const char* option;
  const char* help;
  void (*write)(const Source& source, const Path& file);
};

template <void (*Write)(const SemanticMap& map, const Path& file)>
void writeMap(const Source& source, const Path& file) {
  Write(source.map, file);
}

void writeGeoPackage(const Source& source, const Path& file) {
  exchange::exportGeoPackage(source.map, building::roomsOf(source.map), file);
}

/// Programs for fleets call the map as its file is called.
std::string nameOf(const Source& source) { return source.file.stem().string(); }

void writeZoneSet(const Source& source, const Path& file) { exchange::exportZoneSet(source.map, nameOf(source), file); }

building::RouteNetwork networkOf(const Source& source) {
  query::DrivingRules rules;
  rules.radius_m = source.robotRadius_m;
  rules.forbidden = mapping::zonesOfType(source.map.zones, mapping::ZoneType::Forbidden);
  const query::DrivableFloor floor(source.map.floorPlan, rules);
  auto routes = query::routesThrough(building::roomsOf(source.map), floor, source.map.zones);
  if (routes.network.lanes.empty())
    throw core::InputError(source.file.string() + ": no ways between rooms are found for a robot of radius " +
                           std::to_string(source.robotRadius_m) + " m; does the map have a floor plan with rooms?");
  for (const std::string& place : routes.leftOut)
    std::cerr << "wardslam: no way leads to " << place << ": no place for a robot of this radius (--robot-radius)\n";
  return std::move(routes.network);
}

void writeNav2Route(const Source& source, const Path& file) { exchange::exportNav2Route(networkOf(source), file); }

void writeRmfGraph(const Source& source, const Path& file) {
  exchange::exportRmfGraph(networkOf(source), nameOf(source), file);
}

void writeOctomap(const Source& source, const Path& file) { exchange::exportOctomap(source.map, file); }

void writeMetricMaps(const Source& source, const Path& file) {
  mrpt_plugin::exportMetricMaps(source.map, file, source.choice);
}

void writeGraph(const Source& source, const Path& file) {
  graph::writePoseGraph(pipeline::readEarlierMap(source.file).graph, file);
}

void writeTrajectory(const Source& source, const Path& file) {
  std::map<graph::KeyframeId, Eigen::Isometry3d> T_map_cam;
  if (!source.poses.empty()) T_map_cam = graph::readPoseGraph(source.poses);
  exchange::TumTrajectoryWriter trajectory(file);
  for (const auto& [id, keyframe] : source.map.keyframes) {
    if (source.poses.empty()) T_map_cam[id] = keyframe.T_map_cam;
    const auto pose = T_map_cam.find(id);
    if (pose == T_map_cam.end())
      throw core::InputError(source.poses.string() + ": has no node for keyframe " + std::to_string(id) +
                             " of the map");
    trajectory.write({keyframe.stamp_s, pose->second});
  }
  trajectory.finish();
}

constexpr std::array<Format, 18> kFormats = {{
    {"--ply", "the cloud: colour, class and instance of every point", writeMap<exchange::exportPly>},
    {"--pcd", "the cloud, for PCL: rgb, label, instance", writeMap<exchange::exportPcd>},
    {"--octomap", "occupied and free space: F.bt, or with probabilities F.ot", writeOctomap},
    {"--scene", "cloud, boxes, zones and way, for SceneViewer3D: F.3Dscene", writeMap<viewer::exportScene>},
    {"--gridmap", "the floor plan for MRPT: F.gridmap", writeMap<exchange::exportGridmap>},
    {"--metric-maps", "all as one CMultiMetricMap of MRPT: F.metricmap", writeMetricMaps},
    {"--simplemap", "keyframes with what they saw, for observations2map: F.simplemap",
     writeMap<exchange::exportSimpleMap>},
    {"--graph", "keyframes and what ties them, for graph-slam: F.graph", writeGraph},
    {"--trajectory", "the poses of the keyframes, as `wardslam eval` reads them", writeTrajectory},
    {"--ros-map", "the floor plan for ROS map_server: F.yaml, with F.pgm beside it", writeMap<exchange::exportRosMap>},
    {"--geojson", "zones and objects as polygons, metres", writeMap<exchange::exportGeoJson>},
    {"--geopackage", "also rooms and ways, for GIS programs, which know then that it is metres: F.gpkg",
     writeGeoPackage},
    {"--csv", "the objects, one per line", writeMap<exchange::exportCsv>},
    {"--zone-set", "what zones ask of robots, as VDA 5050 3.0 says it: F.json", writeZoneSet},
    {"--nav2-keepout", "forbidden zones for Nav2's KeepoutFilter: F.yaml, with F.pgm beside it",
     writeMap<exchange::exportKeepoutMask>},
    {"--nav2-speed", "slow zones for Nav2's SpeedFilter: F.yaml, with F.pgm and F.filter_info.yaml beside it",
     writeMap<exchange::exportSpeedMask>},
    {"--nav2-route", "ways through rooms and doors for Nav2's route server: F.geojson", writeNav2Route},
    {"--rmf-graph", "the same as navigation graph of Open-RMF: F.yaml", writeRmfGraph},
}};

/// What `--maps` may name.
constexpr std::array<std::pair<const char*, bool mrpt_plugin::MetricMapChoice::*>, 5> kMetricMaps = {{
    {"semantic", &mrpt_plugin::MetricMapChoice::semantic},
    {"points", &mrpt_plugin::MetricMapChoice::points},
    {"grid", &mrpt_plugin::MetricMapChoice::grid},
    {"octomap", &mrpt_plugin::MetricMapChoice::octoMap},
    {"coloured_octomap", &mrpt_plugin::MetricMapChoice::colouredOctoMap},
}};

struct ExportArguments {
  Path map;
  Path poses;
  std::vector<std::string> maps;
  double robotRadius_m = query::DrivingRules().radius_m;
  std::array<Path, kFormats.size()> files;
};

/// The default, where none is named.
mrpt_plugin::MetricMapChoice choiceOf(const std::vector<std::string>& maps) {
  mrpt_plugin::MetricMapChoice choice;
  if (maps.empty()) return choice;
  for (const auto& [name, isWanted] : kMetricMaps)
    choice.*isWanted = std::find(maps.begin(), maps.end(), name) != maps.end();
  return choice;
}

std::vector<std::string> namesOfMetricMaps() {
  std::vector<std::string> names;
  for (const auto& [name, isWanted] : kMetricMaps) names.emplace_back(name);
  return names;
}

void exportAll(const ExportArguments& arguments) {
  if (arguments.files == ExportArguments().files) throw UsageError("map export needs a format, such as --ply FILE");
  const Source source{arguments.map, arguments.poses, choiceOf(arguments.maps), arguments.robotRadius_m,
                      readStoredMap(arguments.map, storage::CloudPart::Include)};
  for (std::size_t i = 0; i < kFormats.size(); ++i) {
    if (arguments.files.at(i).empty()) continue;
    kFormats.at(i).write(source, arguments.files.at(i));
    std::cout << arguments.files.at(i).string() << "\n";
  }
}

}  // namespace

void addMapExportCommand(CLI::App& mapCommand) {
  CLI::App* command = mapCommand.add_subcommand("export", "Write the map in formats other programs read");
  const auto arguments = std::make_shared<ExportArguments>();
  command->add_option("FILE", arguments->map, "a map (.wardmap)")->required();
  for (std::size_t i = 0; i < kFormats.size(); ++i) {
    command->add_option(kFormats.at(i).option, arguments->files.at(i), kFormats.at(i).help)->type_name("F");
  }
  command->add_option("--poses", arguments->poses, "for --trajectory: a graph that graph-slam has optimised, instead")
      ->type_name("F");
  command->add_option("--maps", arguments->maps, "for --metric-maps: which of them; by default all but the last")
      ->delimiter(',')
      ->check(CLI::IsMember(namesOfMetricMaps()));
  command->add_option("--robot-radius", arguments->robotRadius_m, "for ways: of the robot, margin included")
      ->type_name("M")
      ->check(CLI::Range(0.05, 5.0))
      ->capture_default_str();
  command->callback([arguments] { exportAll(*arguments); });
}

}  // namespace wardslam::apps
