#include "eval_command.h"

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "evaluated_trajectories.h"
#include "support/told_at_once.h"
#include "wardslam/core/errors.h"
#include "wardslam/evaluation/absolute_trajectory_error.h"
#include "wardslam/evaluation/coverage.h"
#include "wardslam/evaluation/relative_pose_error.h"
#include "wardslam/exchange/tum_trajectory.h"

namespace wardslam::apps {
namespace {

struct EvalArguments {
  std::filesystem::path groundTruth;
  std::filesystem::path trajectory;
  std::optional<double> rate_hz;
  bool json = false;
};

struct Evaluation {
  evaluation::AbsoluteTrajectoryError ate;
  evaluation::AbsoluteTrajectoryError scaled;  ///< With the scale that fits best.
  double coverage = 0.0;
  evaluation::RelativePoseError rpe;
};

/// When the recording began and ended (UNIX s): its images say so where they are listed beside the ground truth, which
/// often lasts longer than the images.
std::pair<double, double> recordingSpan(const std::filesystem::path& groundTruthFile,
                                        const EvaluatedTrajectories& trajectories) {
  const core::Trajectory& groundTruth = trajectories.groundTruth;
  const std::filesystem::path images = groundTruthFile.parent_path() / "rgb.txt";
  if (!std::filesystem::exists(images)) return {groundTruth.front().stamp_s, groundTruth.back().stamp_s};
  exchange::TrajectoryReading reading;
  reading.rate_hz = trajectories.rate_hz;
  const auto stamps_s = exchange::readTumStamps(images, reading);
  const bool isOneClock =
      stamps_s.front() <= groundTruth.back().stamp_s && groundTruth.front().stamp_s <= stamps_s.back();
  if (!isOneClock) return {groundTruth.front().stamp_s, groundTruth.back().stamp_s};
  return {stamps_s.front(), stamps_s.back()};
}

bool isAboutAThousand(double ratio) { return ratio > 300.0 && ratio < 3000.0; }

/// From one corner of the box around all positions to the opposite one.
double extent_m(const core::Trajectory& trajectory) {
  Eigen::AlignedBox3d box;
  for (const core::StampedPose& pose : trajectory) box.extend(pose.T_map_cam.translation());
  return box.diagonal().norm();
}

void tellOfMillimetres(const EvalArguments& arguments, const EvaluatedTrajectories& trajectories) {
  const double truth_m = extent_m(trajectories.groundTruth);
  const double estimate_m = extent_m(trajectories.estimate);
  const bool isEstimate = isAboutAThousand(estimate_m / truth_m);
  if (!isEstimate && !isAboutAThousand(truth_m / estimate_m)) return;
  const auto& large = isEstimate ? arguments.trajectory : arguments.groundTruth;
  const auto& small = isEstimate ? arguments.groundTruth : arguments.trajectory;
  tellAtOnce(large.string() + ": is about 1000 times as large as " + small.string() +
             "; both are taken for metres: if it is in millimetres, divide its positions by 1000");
}

Evaluation evaluate(const EvalArguments& arguments) {
  const auto trajectories = readEvaluated(arguments.groundTruth, arguments.trajectory, arguments.rate_hz);
  tellOfMillimetres(arguments, trajectories);
  const auto& groundTruth = trajectories.groundTruth;
  const auto& trajectory = trajectories.estimate;
  const auto [begin_s, end_s] = recordingSpan(arguments.groundTruth, trajectories);
  try {
    return {evaluation::absoluteTrajectoryError(groundTruth, trajectory),
            evaluation::absoluteTrajectoryError(groundTruth, trajectory, evaluation::Alignment::Similarity),
            evaluation::coverage(trajectory, begin_s, end_s), evaluation::relativePoseError(groundTruth, trajectory)};
  } catch (const core::InputError& error) {
    throw core::InputError(arguments.groundTruth.string() + " and " + arguments.trajectory.string() + ": " +
                           error.what());
  }
}

nlohmann::ordered_json toJson(const evaluation::ErrorStatistics& errors) {
  return {{"rmse", errors.rmse}, {"mean", errors.mean}, {"median", errors.median},
          {"std", errors.std},   {"min", errors.min},   {"max", errors.max}};
}

/// Figures that could not be computed (NaN) become null.
void printJson(std::ostream& out, const Evaluation& result) {
  nlohmann::ordered_json json;
  json["ate"] = toJson(result.ate.translation_m);
  json["ate"]["pairs"] = result.ate.translation_m.samples;
  json["ate_sim3"] = toJson(result.scaled.translation_m);
  json["ate_sim3"]["scale"] = result.scaled.scale;
  json["coverage"] = result.coverage;
  json["rpe"]["translation_m_per_s"] = toJson(result.rpe.translation_m);
  json["rpe"]["rotation_deg_per_s"] = toJson(result.rpe.rotation_deg);
  json["rpe"]["pairs"] = result.rpe.translation_m.samples;
  out << json.dump(2) << "\n";
}

void printRow(std::ostream& out, const std::string& name, const evaluation::ErrorStatistics& errors) {
  out << std::left << std::setw(14) << name << std::right << std::fixed << std::setprecision(6);
  for (const double value : {errors.rmse, errors.mean, errors.median, errors.std, errors.min, errors.max}) {
    out << std::setw(12);
    std::isnan(value) ? out << "-" : out << value;
  }
  out << std::setw(8) << errors.samples << "\n";
}

void printTable(std::ostream& out, const Evaluation& result) {
  out << std::left << std::setw(14) << "" << std::right;
  for (const char* heading : {"rmse", "mean", "median", "std", "min", "max"}) out << std::setw(12) << heading;
  out << std::setw(8) << "pairs"
      << "\n";
  printRow(out, "ATE [m]", result.ate.translation_m);
  printRow(out, "RPE [m/s]", result.rpe.translation_m);
  printRow(out, "RPE [deg/s]", result.rpe.rotation_deg);
  out << std::left << std::setw(14) << "coverage" << std::right << std::setw(12) << result.coverage << "\n";
}

}  // namespace

void addEvalCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "eval",
      "Compare a trajectory with the truth: absolute (ATE) and relative (RPE, per second) errors as the TUM "
      "RGB-D benchmark defines them, and coverage, the share of the recording's time with a pose");
  auto arguments = std::make_shared<EvalArguments>();
  command
      ->add_option("GROUNDTRUTH", arguments->groundTruth,
                   "true poses, TUM format (timestamp tx ty tz qx qy qz qw); rgb.txt beside it, if any, tells how "
                   "long the recording is")
      ->required();
  command->add_option("TRAJECTORY", arguments->trajectory, "estimated poses, TUM format")->required();
  command
      ->add_option("--rate", arguments->rate_hz,
                   "images a second, where the stamps of a trajectory number images (30 unless given)")
      ->check(CLI::PositiveNumber);
  command->add_flag("--json", arguments->json, "print JSON instead of a table");
  command->callback([arguments] {
    const Evaluation result = evaluate(*arguments);
    arguments->json ? printJson(std::cout, result) : printTable(std::cout, result);
  });
}

}  // namespace wardslam::apps
