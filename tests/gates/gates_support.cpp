#include "gates/gates_support.h"

#include <sched.h>

#include <fstream>
#include <limits>
#include <stdexcept>

#include "integration/cli_test_support.h"
#include "wardslam/evaluation/absolute_trajectory_error.h"
#include "wardslam/exchange/tum_trajectory.h"

namespace wardslam::gates {
namespace fs = std::filesystem;
namespace {

void runOrThrow(const std::string& program, const std::vector<std::string>& arguments) {
  const auto result = test::runProgram(program, arguments);
  if (result.exitCode == 0) return;
  throw std::runtime_error(program + " ended with " + std::to_string(result.exitCode) + ": " + result.err);
}

}  // namespace

fs::path Rendering::labels() const { return rawlog.parent_path() / (rawlog.stem().string() + "_labels"); }

fs::path Rendering::truthFile() const { return rawlog.parent_path() / (rawlog.stem().string() + ".groundtruth.txt"); }

core::Trajectory Rendering::truth() const { return exchange::readTumTrajectory(truthFile()); }

Rendering render(const fs::path& rawlog, const std::vector<std::string>& arguments) {
  std::vector<std::string> all = {"-o", rawlog.string(), "--width", "320", "--height", "240"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  runOrThrow("rawlog-synth", all);
  return {rawlog};
}

core::Trajectory Run::trajectory() const { return exchange::readTumTrajectory(out / "trajectory.txt"); }

core::Trajectory Run::liveTrajectory() const { return exchange::readTumTrajectory(out / "trajectory_live.txt"); }

nlohmann::json Run::summary() const { return nlohmann::json::parse(test::readText(out / "summary.json")); }

Run run(const Rendering& rendering, const fs::path& out, const std::vector<std::string>& arguments) {
  std::vector<std::string> all = {"run", rendering.rawlog.string(), "--out", out.string()};
  all.insert(all.end(), arguments.begin(), arguments.end());
  runOrThrow("wardslam", all);
  return {out};
}

double ate_m(const Rendering& rendering, const Run& run) {
  const auto truth = rendering.truth();
  const auto trajectory = run.trajectory();
  if (trajectory.size() != truth.size()) return std::numeric_limits<double>::quiet_NaN();
  return evaluation::absoluteTrajectoryError(truth, trajectory).translation_m.rmse;
}

OneCore::OneCore() : before_(sizeof(cpu_set_t)) {
  auto* const before = reinterpret_cast<cpu_set_t*>(before_.data());
  if (sched_getaffinity(0, sizeof(cpu_set_t), before) != 0) throw std::runtime_error("sched_getaffinity failed");
  cpu_set_t one;
  CPU_ZERO(&one);
  int core = 0;
  while (!CPU_ISSET(core, before)) ++core;
  CPU_SET(core, &one);
  if (sched_setaffinity(0, sizeof(one), &one) != 0) throw std::runtime_error("sched_setaffinity failed");
}

OneCore::~OneCore() { sched_setaffinity(0, sizeof(cpu_set_t), reinterpret_cast<const cpu_set_t*>(before_.data())); }

}  // namespace wardslam::gates
