#include "eval_objects_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "support/table.h"
#include "wardslam/evaluation/absolute_trajectory_error.h"
#include "wardslam/evaluation/object_evaluation.h"
#include "wardslam/evaluation/object_files.h"
#include "wardslam/exchange/tum_trajectory.h"

namespace wardslam::apps {
namespace {

struct EvalObjectsArguments {
  std::filesystem::path truth;
  std::filesystem::path objects;
  std::filesystem::path trajectory;
  std::filesystem::path groundTruth;
  int maxClass = 255;
  bool verbose = false;
  bool json = false;
};

struct Comparison {
  std::vector<evaluation::TrueObject> truth;
  std::vector<evaluation::FoundObject> found;  ///< In the frame of the truth.
  evaluation::ObjectEvaluation evaluation;
};

template <class Object>
void leaveOutClassesAbove(std::vector<Object>& objects, int maxClass) {
  objects.erase(std::remove_if(objects.begin(), objects.end(), [&](const Object& o) { return o.classId > maxClass; }),
                objects.end());
}

Comparison compare(const EvalObjectsArguments& arguments) {
  Comparison c;
  c.truth = evaluation::readTrueObjects(arguments.truth);
  const auto alignment = evaluation::absoluteTrajectoryError(exchange::readTumTrajectory(arguments.groundTruth),
                                                             exchange::readTumTrajectory(arguments.trajectory));
  c.found = evaluation::transformed(evaluation::readFoundObjects(arguments.objects), alignment.T_groundtruth_estimate);
  leaveOutClassesAbove(c.truth, arguments.maxClass);
  leaveOutClassesAbove(c.found, arguments.maxClass);
  c.evaluation = evaluation::evaluateObjects(c.truth, c.found);
  return c;
}

/// NaN becomes null.
nlohmann::ordered_json toJson(const evaluation::ClassScore& score) {
  return {{"class_name", score.className}, {"wanted", score.wanted}, {"wanted_found", score.wantedFound},
          {"recall", score.recall()},      {"found", score.found},   {"found_true", score.foundTrue},
          {"precision", score.precision()}};
}

void printJson(std::ostream& out, const Comparison& c) {
  nlohmann::ordered_json json = toJson(c.evaluation.all);
  json["center_error_m"] = {{"median", c.evaluation.center_m.median}, {"max", c.evaluation.center_m.max}};
  json["size_error_m"] = {{"median", c.evaluation.size_m.median}, {"max", c.evaluation.size_m.max}};
  json["classes"] = nlohmann::ordered_json::array();
  for (const auto& [id, score] : c.evaluation.classes) json["classes"].push_back(toJson(score));
  out << json.dump(2) << "\n";
}

constexpr int kDecimals = 3;

void addRow(Table& table, const evaluation::ClassScore& score) {
  table.add({score.className, std::to_string(score.wanted), std::to_string(score.wantedFound),
             fixed(score.recall(), kDecimals), std::to_string(score.found), std::to_string(score.foundTrue),
             fixed(score.precision(), kDecimals)});
}

void printTable(std::ostream& out, const Comparison& c) {
  Table table({"class", "wanted", "got", "recall", "found", "true", "precision"});
  for (const auto& [id, score] : c.evaluation.classes) addRow(table, score);
  addRow(table, c.evaluation.all);
  table.print(out);
  out << "box centre: median error " << fixed(c.evaluation.center_m.median, kDecimals)
      << " m; size: " << fixed(c.evaluation.size_m.median, kDecimals) << " m\n";
}

/// Object by object: what was found of it, what was missed, and what is not there.
void printObjects(std::ostream& out, const Comparison& c) {
  std::vector<bool> isMatched(c.found.size(), false);
  std::vector<bool> isFound(c.truth.size(), false);
  for (const auto& [t, f] : c.evaluation.matches) {
    isMatched[f] = isFound[t] = true;
    out << "  true   " << c.truth[t].name << " = " << c.found[f].id << ", centre off by "
        << fixed((c.truth[t].box_m.center() - c.found[f].box_m.center()).norm(), kDecimals) << " m\n";
  }
  for (std::size_t t = 0; t < c.truth.size(); ++t) {
    const bool isWanted = c.truth[t].framesVisible >= evaluation::SeenWell{}.frames &&
                          c.truth[t].maxPixels >= evaluation::SeenWell{}.pixels;
    if (isWanted && !isFound[t]) out << "  missed " << c.truth[t].name << "\n";
  }
  for (std::size_t f = 0; f < c.found.size(); ++f) {
    if (isMatched[f]) continue;
    out << "  false  " << c.found[f].id << " " << c.found[f].className << " at " << c.found[f].centroid_m.transpose()
        << "\n";
  }
}

}  // namespace

void addEvalObjectsCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "eval-objects",
      "Compare the objects of a map with those that truly stand there, one to one: same class, and box centres within "
      "0.25 m, or boxes that overlap (IoU > 0.25), or the centroid inside the true box. Recall counts true objects "
      "seen in 15 frames and with 1500 pixels in one; precision counts all objects of the map");
  auto arguments = std::make_shared<EvalObjectsArguments>();
  command->add_option("TRUTH", arguments->truth, "true objects (CSV with a header line)")->required();
  command
      ->add_option("OBJECTS", arguments->objects, "objects.json of a run (wardslam map objects MAP --json writes one)")
      ->required();
  command->add_option("--trajectory", arguments->trajectory, "of the run, TUM format")->required();
  command->add_option("--ground-truth", arguments->groundTruth, "true poses, in the frame of the true objects")
      ->required();
  command->add_option("--max-class", arguments->maxClass, "leave out classes with higher ids; 80 for a COCO network");
  command->add_flag("--objects", arguments->verbose, "list every object too");
  command->add_flag("--json", arguments->json, "print JSON instead of a table");
  command->callback([arguments] {
    const Comparison c = compare(*arguments);
    arguments->json ? printJson(std::cout, c) : printTable(std::cout, c);
    if (arguments->verbose && !arguments->json) printObjects(std::cout, c);
  });
}

}  // namespace wardslam::apps
