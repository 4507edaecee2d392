#include "eval_rooms_command.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "stored_map.h"
#include "support/table.h"
#include "wardslam/building/rooms_of_map.h"
#include "wardslam/core/errors.h"
#include "wardslam/evaluation/absolute_trajectory_error.h"
#include "wardslam/evaluation/floor_plan_evaluation.h"
#include "wardslam/evaluation/true_building.h"
#include "wardslam/exchange/tum_trajectory.h"

namespace wardslam::apps {
namespace {

using Json = nlohmann::ordered_json;

struct EvalRoomsArguments {
  std::filesystem::path truth;
  std::filesystem::path map;
  std::filesystem::path trajectory;
  std::filesystem::path groundTruth;
  int storey = 0;
  building::RoomOptions rooms;
  bool json = false;
};

Eigen::Isometry2d T_truth_map(const EvalRoomsArguments& arguments) {
  if (arguments.trajectory.empty()) return Eigen::Isometry2d::Identity();
  return evaluation::onFloor(evaluation::absoluteTrajectoryError(exchange::readTumTrajectory(arguments.groundTruth),
                                                                 exchange::readTumTrajectory(arguments.trajectory))
                                 .T_groundtruth_estimate);
}

evaluation::RoomEvaluation evaluate(const EvalRoomsArguments& arguments) {
  const auto truth = evaluation::readTrueBuilding(arguments.truth, arguments.storey);
  const auto map = readStoredMap(arguments.map, storage::CloudPart::Include);
  if (map.floorPlan.cells.empty()) throw core::InputError(arguments.map.string() + ": the map has no floor plan");
  const auto found = building::roomsOf(map, arguments.rooms);
  evaluation::RoomEvaluationOptions options;
  options.widestDoor_m = arguments.rooms.widestDoor_m;
  return evaluation::evaluateRooms(truth, map.floorPlan, found, T_truth_map(arguments), options);
}

double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? std::numeric_limits<double>::quiet_NaN() : static_cast<double>(part) / static_cast<double>(whole);
}

/// NaN becomes null.
void printJson(std::ostream& out, const evaluation::RoomEvaluation& result) {
  Json rooms = Json::array();
  for (const auto& room : result.rooms) {
    rooms.push_back({{"name", room.name},
                     {"seen_m2", room.seen_m2},
                     {"room", room.found},
                     {"intersection_over_union", room.overlap},
                     {"found", room.isFound}});
  }
  const Json json = {{"rooms", result.rooms.size()},
                     {"rooms_told", result.told},
                     {"rooms_found", result.found},
                     {"recall", share(result.found, result.rooms.size())},
                     {"precision", share(result.found, result.told)},
                     {"intersection_over_union", result.meanOverlap()},
                     {"splits", result.splits},
                     {"joins", result.joins},
                     {"doors", result.doors},
                     {"doors_told", result.doorsTold},
                     {"doors_found", result.doorsFound},
                     {"each", rooms}};
  out << json.dump(2) << "\n";
}

void printText(std::ostream& out, const evaluation::RoomEvaluation& result) {
  constexpr int kAreaDecimals = 1;
  constexpr int kRatioDecimals = 2;
  Table each({"room", "seen m2", "is most like", "IoU", "found"});
  for (const auto& room : result.rooms) {
    each.add({room.name, fixed(room.seen_m2, kAreaDecimals), room.found, fixed(room.overlap, kRatioDecimals),
              room.isFound ? "yes" : "no"});
  }
  each.print(out);
  out << "\n";
  Table all({"", "wanted", "got", "recall", "told", "true", "precision"});
  const auto add = [&](const char* what, std::size_t wanted, std::size_t found, std::size_t told) {
    all.add({what, std::to_string(wanted), std::to_string(found), fixed(share(found, wanted), kRatioDecimals),
             std::to_string(told), std::to_string(found), fixed(share(found, told), kRatioDecimals)});
  };
  add("rooms", result.rooms.size(), result.found, result.told);
  add("doors", result.doors, result.doorsFound, result.doorsTold);
  all.print(out);
  out << "rooms found: intersection over union " << fixed(result.meanOverlap(), kRatioDecimals) << " on average; "
      << result.splits << " too many by splits, " << result.joins << " too few by joins\n";
}

}  // namespace

void addEvalRoomsCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "eval-rooms",
      "Compare the rooms and doors that a map's floor plan shows with the true ones, on the floor it knows");
  auto arguments = std::make_shared<EvalRoomsArguments>();
  command->add_option("TRUTH", arguments->truth, "the true rooms (rooms.geojson of rawlog-synth)")->required();
  command->add_option("MAP", arguments->map, "the map (.wardmap)")->required();
  auto* trajectory = command->add_option("--trajectory", arguments->trajectory,
                                         "of the run, in the frame of the map, TUM format; without it the map is "
                                         "taken to be in the frame of the truth");
  auto* groundTruth =
      command->add_option("--ground-truth", arguments->groundTruth, "true poses, in the frame of the true rooms");
  trajectory->needs(groundTruth);
  groundTruth->needs(trajectory);
  command->add_option("--storey", arguments->storey, "of the true building that the map is of")->capture_default_str();
  command->add_option("--widest-door", arguments->rooms.widestDoor_m, "m; what a wider passage joins is one room")
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "print JSON instead of text");
  command->callback([arguments] {
    const auto result = evaluate(*arguments);
    arguments->json ? printJson(std::cout, result) : printText(std::cout, result);
  });
}

}  // namespace wardslam::apps
