#include "sweep_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "parameter_grid.h"
#include "recorded_run.h"
#include "recording_arguments.h"
#include "support/interruption.h"
#include "support/program.h"
#include "sweep_table.h"
#include "wardslam/core/atomic_file.h"
#include "wardslam/core/errors.h"
#include "wardslam/pipeline/slam_system.h"
#include "wardslam/sources/sensor_configuration.h"

namespace wardslam::apps {
namespace {

namespace fs = std::filesystem;

struct SweepArguments {
  RecordingArguments recording;
  std::vector<std::string> parameters;
  fs::path groundTruth;
};

/// A cell and how it is run; without options where its values exclude each other.
struct Plan {
  SweepRow row;
  fs::path folder;
  std::optional<pipeline::SlamOptions> options;
  std::string configuration;
};

std::string readText(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<Plan> planCells(const SweepArguments& arguments, const std::vector<SweptParameter>& parameters) {
  auto base = effectiveOptions(arguments.recording);
  base.deterministic = true;  // cells are compared: nothing but the parameters may differ
  const std::string configuration = pipeline::SlamSystem(base).configuration();
  std::vector<Plan> plans;
  for (const GridCell& cell : combinations(parameters)) {
    std::string name = nameOf(parameters, cell);
    std::replace(name.begin(), name.end(), '/', '_');
    Plan plan{{cell, {}, {}}, arguments.recording.out / "cells" / name, {}, {}};
    const auto node = withParameters(configuration, base.file, parameters, cell);
    try {
      auto options = pipeline::readSlamOptions(node);
      plan.configuration = pipeline::SlamSystem(options).configuration();
      plan.options = std::move(options);
    } catch (const core::InputError& error) {
      plan.row.note = error.what();
    }
    plans.push_back(std::move(plan));
  }
  return plans;
}

/// A value that no combination can use is a mistake; two that exclude each other are not.
void requireUsefulValues(const std::vector<SweptParameter>& parameters, const std::vector<Plan>& plans) {
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    for (const std::string& value : parameters[i].values) {
      const auto hasValue = [&](const Plan& plan) { return plan.row.cell[i] == value; };
      const auto canRun = [&](const Plan& plan) { return hasValue(plan) && plan.options; };
      if (std::any_of(plans.begin(), plans.end(), canRun)) continue;
      const auto& refused = *std::find_if(plans.begin(), plans.end(), hasValue);
      throw core::InputError("--param " + parameters[i].name + "=" + value + ": " + refused.row.note);
    }
  }
}

/// Results of another recording must not be taken for those of this one.
void claimFolder(const RecordingArguments& recording) {
  nlohmann::ordered_json identity;
  identity["input"] = fs::absolute(recording.input).lexically_normal().string();
  identity["camera"] = recording.camera.empty() ? "" : fs::absolute(recording.camera).lexically_normal().string();
  identity["dynamic_truth"] =
      recording.dynamicTruth.empty() ? "" : fs::absolute(recording.dynamicTruth).lexically_normal().string();
  identity["max_frames"] = recording.maxFrames.value_or(0);
  const fs::path file = recording.out / "sweep.json";
  const std::string text = identity.dump(2) + "\n";
  if (fs::exists(file) && readText(file) != text) {
    throw core::InputError(file.string() +
                           ": the results there are of another recording, or of another part of it; "
                           "give another --out, or delete that folder");
  }
  std::error_code error;
  fs::create_directories(recording.out, error);
  if (error) throw core::InputError(recording.out.string() + ": cannot be made: " + error.message());
  core::writeFileAtomically(file, text);
}

/// summary.json is the last file of a run; an interrupted run says so in it.
bool isFinished(const Plan& plan) {
  const auto summary = nlohmann::json::parse(readText(plan.folder / "summary.json"), nullptr, false);
  return summary.is_object() && !summary.value("interrupted", true) &&
         readText(plan.folder / "config.yaml") == plan.configuration;
}

class Sweep {
 public:
  explicit Sweep(const SweepArguments& arguments) : arguments_(arguments) {
    for (const std::string& text : arguments.parameters) {
      SweptParameter parameter = parseSweptParameter(text);
      const auto isSame = [&](const SweptParameter& other) { return other.name == parameter.name; };
      if (std::any_of(parameters_.begin(), parameters_.end(), isSame)) {
        throw UsageError("--param " + parameter.name + ": given twice; name all its values in one");
      }
      parameters_.push_back(std::move(parameter));
    }
    plans_ = planCells(arguments, parameters_);
    requireUsefulValues(parameters_, plans_);
    claimFolder(arguments.recording);
  }

  /// What is finished already is kept. Throws the first trouble with the input when all is done.
  void perform() {
    const InterruptionGuard interruption;
    for (std::size_t i = 0; i < plans_.size() && !interruption.requested(); ++i) {
      Plan& plan = plans_[i];
      if (!plan.options) continue;
      if (isFinished(plan) || performCell(plan, i, interruption)) plan.row.results = plan.folder;
      writeTable();
    }
    std::cout << table().markdown() << std::flush;
    if (!firstTrouble_.empty()) throw core::InputError(firstTrouble_);
  }

 private:
  bool performCell(Plan& plan, std::size_t number, const InterruptionGuard& interruption) {
    std::error_code ignored;
    fs::remove(plan.folder / "summary.json", ignored);  // of other parameters
    RecordedRun run;
    run.input = arguments_.recording.input;
    run.camera = arguments_.recording.camera;
    run.depthFactor = arguments_.recording.depthFactor;
    run.topics = arguments_.recording.topics;
    run.out = plan.folder;
    run.options = *plan.options;
    run.maxFrames = arguments_.recording.maxFrames;
    run.dynamicTruth = arguments_.recording.dynamicTruth;
    run.progressUnit = "run " + std::to_string(number + 1) + "/" + std::to_string(plans_.size()) + ", frame";
    try {
      return apps::perform(run, interruption);
    } catch (const core::InputError& error) {
      if (!isFinished(plan)) throw;
      plan.row.note = error.what();  // the run is complete all the same
      if (firstTrouble_.empty()) firstTrouble_ = error.what();
      return true;
    }
  }

  [[nodiscard]] SweepTable table() const {
    std::vector<SweepRow> rows;
    for (const Plan& plan : plans_) rows.push_back(plan.row);
    return {parameters_, rows, arguments_.groundTruth};
  }

  void writeTable() const {
    const SweepTable now = table();
    core::writeFileAtomically(arguments_.recording.out / "sweep.csv", now.csv());
    core::writeFileAtomically(arguments_.recording.out / "sweep.md", now.markdown());
  }

  const SweepArguments& arguments_;
  std::vector<SweptParameter> parameters_;
  std::vector<Plan> plans_;
  std::string firstTrouble_;
};

void requireRecording(const fs::path& input) {
  if (sources::isSensorConfiguration(input)) throw UsageError("a sweep needs a recording, which a camera is not");
}

}  // namespace

void addSweepCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "sweep",
      "Run a recording with every combination of parameter values and put the results side by side (sweep.csv, "
      "sweep.md). Run again after an interruption, it goes on with what is missing");
  auto arguments = std::make_shared<SweepArguments>();
  addRecordingArguments(*command, arguments->recording);
  command
      ->add_option("--param", arguments->parameters,
                   "NAME=A,B,…: a parameter of the configuration and its values; filter.n is parameter n of the "
                   "semantic filter. May be given several times")
      ->required()
      ->allow_extra_args(false);
  command->add_option("--ground-truth", arguments->groundTruth, "true poses, TUM format, for the error")
      ->check(CLI::ExistingFile);
  command->callback([arguments] {
    requireRecording(arguments->recording.input);
    Sweep(*arguments).perform();
  });
}

}  // namespace wardslam::apps
