#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "wardslam/fleet/stored_maps.h"

namespace wardslam::apps {

inline void addDatabase(CLI::App& command, std::string& database) {
  command.add_option("--database", database, "postgresql://USER@HOST/DATABASE; else $WARDSLAM_DATABASE")
      ->envname("WARDSLAM_DATABASE")
      ->required();
}

inline void addChoice(CLI::App& command, fleet::MapChoice& choice) {
  command.add_option("--site", choice.site, "only maps of this site");
  command.add_option("--storey", choice.storey, "only maps of this storey");
  command.add_option("--robot", choice.robot, "only maps of this robot");
  command.add_option("--name", choice.name, "only maps of this name");
}

}  // namespace wardslam::apps
