#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "arguments/arguments.h"
#include "arguments/one_of.h"

namespace wardslam::synth {

void declareHospital(CLI::App& app, HospitalOptions& options) {
  app.option_defaults()->group("Hospital (--scene hospital)");
  app.add_option("--route", options.route.kind,
                 "tour (unless told): 500 m and more through everything; wards: one lap that calls at every open ward, "
                 "some 240 m; round: one lap, some 140 m; corridor: the long one up and down, some 120 m; lobby: some "
                 "25 m")
      ->type_name("TEXT")
      ->transform(oneOf<RouteKind>({{"tour", RouteKind::Tour},
                                    {"wards", RouteKind::Wards},
                                    {"round", RouteKind::Round},
                                    {"corridor", RouteKind::Corridor},
                                    {"lobby", RouteKind::Lobby}}));
  app.add_option("--robot", options.route.robot, "another robot: it begins elsewhere and drives in another order")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  app.add_option("--day", options.day, "so many days later: things were moved, taken away and brought")
      ->check(CLI::Range(0, kLastDay))
      ->capture_default_str();
  app.add_option("--storeys", options.storeys,
                 "so many, one above the other; each has rooms and people of its own. No way leads from one to another")
      ->check(CLI::Range(1, kMostStoreys))
      ->capture_default_str();
  app.add_option("--storey", options.storey, "which of them is driven on, from 0, the lowest")
      ->check(CLI::Range(0, kMostStoreys - 1))
      ->capture_default_str();
  std::vector<std::string> names;
  for (const auto& [name, density] : densities()) names.push_back(name);
  app.add_option_function<std::string>(
         "--people", [&options](const std::string& name) { options.people = densities().at(name); },
         "who walks about: none, few (10), normal (26), busy (54) or crowd (90, some of them around the camera)")
      ->check(CLI::IsMember(names))
      ->default_str("normal");
}

}  // namespace wardslam::synth
