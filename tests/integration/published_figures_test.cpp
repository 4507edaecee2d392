#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "cli_test_support.h"

/// What `wardslam eval` says beside what the TUM benchmark's own scripts print for the same trajectories, digit by
/// digit.
namespace wardslam {
namespace {

namespace fs = std::filesystem;
using Figures = std::map<std::string, std::string>;  // "translational_error.rmse" -> "0.021217"

const fs::path kTrajectories = fs::path(WARDSLAM_SHARED_DIR) / "data" / "trajectories";

/// Adds the scripts' output ("name value unit" per line), from the line `heading` on where one is given, to the next.
void addPublished(Figures& figures, const fs::path& file, const std::string& heading = {}) {
  std::ifstream in(file);
  bool inside = heading.empty();
  std::string pairs;
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("==", 0) == 0) inside = line == heading;
    std::istringstream words(line);
    std::string name, value, unit;
    if (!inside || !(words >> name >> value >> unit) || name == "==") continue;
    if (name == "compared_pose_pairs") {
      pairs = value;
    } else {
      figures[name] = value;
      figures[name.substr(0, name.find('.')) + ".pairs"] = pairs;
    }
  }
}

std::string sixDigits(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.6f", value);
  return text;
}

void addOurs(Figures& figures, const std::string& name, const nlohmann::json& errors, const nlohmann::json& pairs) {
  figures[name + ".pairs"] = pairs.dump();
  for (const char* figure : {"rmse", "mean", "median", "std", "min", "max"}) {
    figures[name + "." + figure] = sixDigits(errors.at(figure).get<double>());
  }
}

nlohmann::json evaluate(const fs::path& groundTruth, const fs::path& estimate) {
  const auto result = test::runProgram("wardslam", {"eval", "--json", groundTruth, estimate});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  return nlohmann::json::parse(result.out);
}

Figures ours(const nlohmann::json& evaluation) {
  Figures figures;
  const auto& rpe = evaluation.at("rpe");
  addOurs(figures, "absolute_translational_error", evaluation.at("ate"), evaluation.at("ate").at("pairs"));
  addOurs(figures, "translational_error", rpe.at("translation_m_per_s"), rpe.at("pairs"));
  addOurs(figures, "rotational_error", rpe.at("rotation_deg_per_s"), rpe.at("pairs"));
  return figures;
}

class PublishedFigures : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!fs::exists(kTrajectories)) GTEST_SKIP() << "the published trajectories are not here: " << kTrajectories;
  }
};

using RgbdSlamRuns = PublishedFigures;
using DynaSlamRuns = PublishedFigures;

TEST_P(RgbdSlamRuns, AreEqualToTheDigit) {
  const std::string name = GetParam();
  const fs::path folder = kTrajectories / "rgbdslam_runs";
  Figures published;
  addPublished(published, folder / "golden.txt", "== " + name);
  ASSERT_EQ(published.size(), 21U) << "three errors, seven figures each";
  EXPECT_EQ(ours(evaluate(folder / (name + "-groundtruth.txt"), folder / (name + "-rgbdslam.txt"))), published);
}

TEST_P(DynaSlamRuns, AreEqualToTheDigit) {
  const std::string name = GetParam();
  const fs::path folder = kTrajectories / "dynaslam_run" / name;
  Figures published;
  addPublished(published, folder / (name + "_ate_0.txt"));
  addPublished(published, folder / (name + "_rpe_0.txt"));
  ASSERT_EQ(published.size(), 21U) << "three errors, seven figures each";

  auto evaluation = evaluate(kTrajectories / "groundtruth_fr3" / (name + ".txt"), folder / "CameraTrajectory_0.txt");
  // The script of that time printed the median rotation in radians, labelled degrees.
  auto& median = evaluation.at("rpe").at("rotation_deg_per_s").at("median");
  median = median.get<double>() * M_PI / 180.0;
  EXPECT_EQ(ours(evaluation), published);
}

const auto nameOf = [](const ::testing::TestParamInfo<const char*>& info) { return std::string(info.param); };
INSTANTIATE_TEST_SUITE_P(, RgbdSlamRuns, ::testing::Values("freiburg1_xyz", "freiburg1_desk", "freiburg1_room"),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(, DynaSlamRuns,
                         ::testing::Values("fr3_walk_xyz", "fr3_walk_static", "fr3_walk_rpy", "fr3_walk_halfsphere",
                                           "fr3_sitting_static"),
                         nameOf);

}  // namespace
}  // namespace wardslam
