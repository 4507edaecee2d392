#include "map_export_command.h"

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "stored_map.h"
#include "support/program.h"
#include "wardslam/exchange/map_export.h"
#include "wardslam/viewer/map_scene.h"

namespace wardslam::apps {
namespace {

using Path = std::filesystem::path;
using mapping::SemanticMap;

struct Format {
  const char* option;
  const char* help;
  void (*write)(const SemanticMap& map, const Path& file);
};

void exportOctomap(const SemanticMap& map, const Path& file) { exchange::exportOctomap(map, file); }

constexpr std::array<Format, 8> kFormats = {{
    {"--ply", "the cloud: colour, class and instance of every point", exchange::exportPly},
    {"--pcd", "the cloud, for PCL: rgb, label, instance", exchange::exportPcd},
    {"--octomap", "occupied and free space: F.bt, or with probabilities F.ot", exportOctomap},
    {"--scene", "cloud, boxes, zones and way, for SceneViewer3D: F.3Dscene", viewer::exportScene},
    {"--gridmap", "the floor plan for MRPT: F.gridmap", exchange::exportGridmap},
    {"--ros-map", "the floor plan for ROS map_server: F.yaml, with F.pgm beside it", exchange::exportRosMap},
    {"--geojson", "zones and objects as polygons, metres", exchange::exportGeoJson},
    {"--csv", "the objects, one per line", exchange::exportCsv},
}};

struct ExportArguments {
  Path map;
  std::array<Path, kFormats.size()> files;
};

void exportAll(const ExportArguments& arguments) {
  if (arguments.files == ExportArguments().files) throw UsageError("map export needs a format, such as --ply FILE");
  const SemanticMap map = readStoredMap(arguments.map, storage::CloudPart::Include);
  for (std::size_t i = 0; i < kFormats.size(); ++i) {
    if (arguments.files.at(i).empty()) continue;
    kFormats.at(i).write(map, arguments.files.at(i));
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
  command->callback([arguments] { exportAll(*arguments); });
}

}  // namespace wardslam::apps
