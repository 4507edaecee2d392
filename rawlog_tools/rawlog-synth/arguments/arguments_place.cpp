#include <CLI/CLI.hpp>

#include "arguments/arguments.h"

namespace wardslam::synth {

void declarePlace(CLI::App& app, PlaceOptions& options) {
  std::vector<std::string> names;
  std::string descriptions;
  for (const Place& place : places()) {
    names.push_back(place.name);
    descriptions += (descriptions.empty() ? "" : "; ") + place.name + ": " + place.description;
  }
  app.option_defaults()->group("Place");
  app.add_option("--scene", options.name, descriptions)->check(CLI::IsMember(names));
  app.add_option("--seed", options.scene.seed, "another seed, another place: textures, furniture, noise")
      ->capture_default_str();
  app.add_flag_callback(
      "--no-people", [&options] { options.scene.people = false; },
      "nobody there; in the ward the trolley stands where it would be left");
}

}  // namespace wardslam::synth
