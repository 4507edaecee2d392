#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "child_processes.h"
#include "support/interruption.h"
#include "wardslam/reproduction/cell.h"
#include "wardslam/reproduction/plan.h"

namespace wardslam::apps {

struct ReproduceArguments {
  std::filesystem::path plan;
  std::filesystem::path data = ".";
  std::filesystem::path out;
  int jobs = 0;  ///< 0: as many as there are cores.
  bool fetch = false;
};

/// The runs of a plan, each a process of its own, as many beside each other as there are cores.
class ReproductionRun {
 public:
  /// Looks what there is already. Throws core::InputError when a configuration, network or camera that the plan names
  /// cannot be used.
  ReproductionRun(const reproduction::Plan& plan, const ReproduceArguments& arguments);

  /// Runs what is not finished; on an interruption, what is finished by then stays. `onFinished`: after every cell.
  template <class OnFinished>
  void perform(const InterruptionGuard& interruption, OnFinished onFinished) {
    while (step(interruption)) onFinished();
  }

  [[nodiscard]] std::size_t cells() const { return todo_.size() + underWay_.size() + finished_; }  ///< Can be run.
  [[nodiscard]] std::size_t finished() const { return finished_; }
  [[nodiscard]] std::size_t finishedBefore() const { return finishedBefore_; }
  [[nodiscard]] const reproduction::Results& results() const { return results_; }

  /// Sentences about runs that failed.
  [[nodiscard]] const std::vector<std::string>& troubles() const { return troubles_; }

 private:
  struct Work {
    reproduction::Cell cell;
    std::string identity;
    std::string configuration;
    bool isEvaluated = false;  ///< The process evaluates what it ran before.
  };

  void look(const reproduction::Cell& cell);
  [[nodiscard]] const std::string& configurationOf(const reproduction::Cell& cell);
  [[nodiscard]] const std::string& contentsOf(std::size_t sequence);
  bool step(const InterruptionGuard& interruption);
  void startMore();
  void startRun(Work work);
  void startEvaluation(Work work);
  bool take(const EndedProcess& ended);
  void finish(const Work& work, int exitCode);
  void fail(const Work& work, const std::string& why);
  [[nodiscard]] std::string nameOf(const reproduction::Cell& cell) const;

  const reproduction::Plan& plan_;
  const ReproduceArguments& arguments_;
  std::string program_ = thisProgram();
  reproduction::Results results_;
  std::map<std::pair<std::size_t, std::size_t>, std::string> configurations_;
  std::map<std::size_t, std::string> contents_;
  std::vector<Work> todo_;  ///< The next is the last.
  std::map<pid_t, Work> underWay_;
  std::size_t finished_ = 0;
  std::size_t finishedBefore_ = 0;
  std::vector<std::string> troubles_;
  ChildProcesses processes_;  // the last: those that are left end before what they are known by does
};

}  // namespace wardslam::apps
