#include "eval_floor_command.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "stored_map.h"
#include "support/table.h"
#include "wardslam/core/errors.h"
#include "wardslam/evaluation/absolute_trajectory_error.h"
#include "wardslam/evaluation/floor_plan_evaluation.h"
#include "wardslam/exchange/ros_map.h"
#include "wardslam/exchange/tum_trajectory.h"

namespace wardslam::apps {
namespace {

struct EvalFloorArguments {
  std::filesystem::path truth;
  std::filesystem::path map;
  std::filesystem::path trajectory;
  std::filesystem::path groundTruth;
  bool json = false;
};

evaluation::FloorPlanEvaluation evaluate(const EvalFloorArguments& arguments) {
  const auto groundTruth = exchange::readTumTrajectory(arguments.groundTruth);
  const auto alignment =
      evaluation::absoluteTrajectoryError(groundTruth, exchange::readTumTrajectory(arguments.trajectory));
  std::vector<Eigen::Vector2d> way_m;
  for (const auto& pose : groundTruth) way_m.emplace_back(pose.T_map_cam.translation().head<2>());
  const auto truth = evaluation::reachableFloor(exchange::readRosMap(arguments.truth), way_m);
  const auto found = readStoredMap(arguments.map, storage::CloudPart::Include).floorPlan;
  if (found.cells.empty()) throw core::InputError(arguments.map.string() + ": the map has no floor plan");
  return evaluation::evaluateFloorPlan(truth, found, evaluation::onFloor(alignment.T_groundtruth_estimate));
}

/// NaN becomes null.
void printJson(std::ostream& out, const evaluation::FloorPlanEvaluation& result) {
  const nlohmann::ordered_json json = {{"intersection_over_union", result.intersectionOverUnion()},
                                       {"known_share", result.knownShare()},
                                       {"free_m2", result.free_m2},
                                       {"occupied_m2", result.occupied_m2},
                                       {"unknown_m2", result.unknown_m2},
                                       {"wrongly_free_m2", result.wronglyFree_m2}};
  out << json.dump(2) << "\n";
}

void printText(std::ostream& out, const evaluation::FloorPlanEvaluation& result) {
  constexpr int kAreaDecimals = 1;
  constexpr int kRatioDecimals = 3;
  out << "free floor: intersection over union " << fixed(result.intersectionOverUnion(), kRatioDecimals)
      << " where the map knows it, which is " << fixed(result.knownShare(), kRatioDecimals) << " of it\n"
      << "truly free, and told free " << fixed(result.free_m2, kAreaDecimals) << " m2, occupied "
      << fixed(result.occupied_m2, kAreaDecimals) << " m2, unknown " << fixed(result.unknown_m2, kAreaDecimals)
      << " m2; told free and not " << fixed(result.wronglyFree_m2, kAreaDecimals) << " m2\n";
}

}  // namespace

void addEvalFloorCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "eval-floor",
      "Compare the floor plan of a map with the true one: the free floor that can be reached from the true way of the "
      "camera, cell by cell");
  auto arguments = std::make_shared<EvalFloorArguments>();
  command->add_option("TRUTH", arguments->truth, "the true floor plan (YAML of ROS map_server)")->required();
  command->add_option("MAP", arguments->map, "the map (.wardmap)")->required();
  command->add_option("--trajectory", arguments->trajectory, "of the run, in the frame of the map, TUM format")
      ->required();
  command->add_option("--ground-truth", arguments->groundTruth, "true poses, in the frame of the true floor plan")
      ->required();
  command->add_flag("--json", arguments->json, "print JSON instead of text");
  command->callback([arguments] {
    const auto result = evaluate(*arguments);
    arguments->json ? printJson(std::cout, result) : printText(std::cout, result);
  });
}

}  // namespace wardslam::apps
