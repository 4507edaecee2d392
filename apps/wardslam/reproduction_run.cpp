#include "reproduction_run.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <thread>

#include "wardslam/core/atomic_file.h"
#include "wardslam/core/errors.h"
#include "wardslam/pipeline/slam_system.h"

namespace wardslam::apps {
namespace {

namespace fs = std::filesystem;
using reproduction::Cell;
using reproduction::Sequence;

std::string readText(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

ReproductionRun::ReproductionRun(const reproduction::Plan& plan, const ReproduceArguments& arguments)
    : plan_(plan), arguments_(arguments) {
  for (const Cell& cell : reproduction::cellsOf(plan, arguments.out)) look(cell);
  std::reverse(todo_.begin(), todo_.end());
  finishedBefore_ = finished_;
}

void ReproductionRun::look(const Cell& cell) {
  const std::string why = reproduction::whyNot(plan_, cell, arguments_.data);
  if (!why.empty()) return results_.setAbsent(cell.sequence, cell.variant, why);
  Work work{cell, {}, {}, false};
  work.configuration =
      reproduction::withKeyPoints(configurationOf(cell), reproduction::keyPointsMore(plan_, cell.repetition));
  work.identity =
      reproduction::identityOf(plan_, cell, contentsOf(cell.sequence), work.configuration, WARDSLAM_VERSION);
  if (auto result = reproduction::finishedResult(cell, work.identity)) {
    results_.add(cell.sequence, cell.variant, std::move(*result));
    ++finished_;
  } else {
    todo_.push_back(std::move(work));
  }
}

const std::string& ReproductionRun::configurationOf(const Cell& cell) {
  std::string& configuration = configurations_[{cell.sequence, cell.variant}];
  if (configuration.empty()) {
    configuration = pipeline::SlamSystem(reproduction::optionsOf(plan_, cell, arguments_.data)).configuration();
  }
  return configuration;
}

const std::string& ReproductionRun::contentsOf(std::size_t sequence) {
  std::string& contents = contents_[sequence];
  if (contents.empty()) contents = reproduction::contentsOf(plan_, sequence, arguments_.data);
  return contents;
}

/// Until a cell is finished, or failed. False: there is none left.
bool ReproductionRun::step(const InterruptionGuard& interruption) {
  while (!interruption.requested()) {
    startMore();
    if (processes_.running() == 0) return false;
    if (const auto ended = processes_.reap()) {
      if (take(*ended)) return true;
    } else {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }
  return false;
}

void ReproductionRun::startMore() {
  const auto most = static_cast<std::size_t>(arguments_.jobs > 0 ? arguments_.jobs : usableCores());
  while (!todo_.empty() && processes_.running() < most) {
    Work work = std::move(todo_.back());
    todo_.pop_back();
    startRun(std::move(work));
  }
}

void ReproductionRun::startRun(Work work) {
  const Cell& cell = work.cell;
  reproduction::beginCell(cell, work.identity);
  const fs::path configuration = cell.folder / "config.yaml";
  core::writeFileAtomically(configuration, work.configuration);
  std::vector<std::string> arguments = {
      "run",      reproduction::folderOf(plan_.sequences[cell.sequence], arguments_.data),
      "--out",    cell.folder / "run",
      "--config", configuration};
  const fs::path camera = reproduction::cameraOf(plan_, cell.sequence);
  if (!camera.empty()) arguments.insert(arguments.end(), {"--camera", camera});
  if (plan_.max_frames > 0) arguments.insert(arguments.end(), {"--max-frames", std::to_string(plan_.max_frames)});
  const pid_t process = processes_.start(program_, arguments, cell.folder / "run.out", cell.folder / "run.err");
  underWay_.emplace(process, std::move(work));
}

void ReproductionRun::startEvaluation(Work work) {
  const Cell& cell = work.cell;
  const Sequence& sequence = plan_.sequences[cell.sequence];
  const fs::path truth = reproduction::folderOf(sequence, arguments_.data) / sequence.ground_truth;
  const pid_t process = processes_.start(program_, {"eval", truth, cell.folder / "run" / "trajectory.txt", "--json"},
                                         cell.folder / "eval.json", cell.folder / "eval.err");
  work.isEvaluated = true;
  underWay_.emplace(process, std::move(work));
}

/// Whether a cell came to its end with it.
bool ReproductionRun::take(const EndedProcess& ended) {
  Work work = std::move(underWay_.at(ended.process));
  underWay_.erase(ended.process);
  if (work.isEvaluated) {
    finish(work, ended.exitCode);
    return true;
  }
  if (ended.exitCode != 0) {
    fail(work, lastLine(work.cell.folder / "run.err"));
    return true;
  }
  startEvaluation(std::move(work));
  return false;
}

void ReproductionRun::finish(const Work& work, int exitCode) {
  const std::string trouble = exitCode == 0 ? "" : lastLine(work.cell.folder / "eval.err");
  const std::string evaluation = exitCode == 0 ? readText(work.cell.folder / "eval.json") : "";
  if (!trouble.empty()) troubles_.push_back(nameOf(work.cell) + ": " + trouble);
  results_.add(work.cell.sequence, work.cell.variant, reproduction::finishCell(work.cell, evaluation, trouble));
  ++finished_;
}

void ReproductionRun::fail(const Work& work, const std::string& why) {
  troubles_.push_back(nameOf(work.cell) + ": " + (why.empty() ? "ended without a word" : why));
  reproduction::RunResult result;
  result.trouble = why;
  results_.add(work.cell.sequence, work.cell.variant, result);
  ++finished_;
}

std::string ReproductionRun::nameOf(const Cell& cell) const {
  return plan_.sequences[cell.sequence].name + ", " + plan_.variants[cell.variant].name + ", repetition " +
         std::to_string(cell.repetition);
}

}  // namespace wardslam::apps
