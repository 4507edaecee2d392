#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli_test_support.h"

/// How near the trajectories of real and rendered recordings come to the truth: limits that no change may break.
namespace wardslam {
namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

const fs::path kData = fs::path(WARDSLAM_SHARED_DIR) / "data";
const fs::path kNetwork = fs::path(WARDSLAM_SHARED_DIR) / "models" / "yolov8n-seg_320x256.onnx";
const std::string kFreiburg1 = fs::path(WARDSLAM_CONFIG_DIR) / "cameras" / "tum_freiburg1.yaml";

class Accuracy : public ::testing::Test {
 protected:
  struct Figures {
    double ate_m = 0.0;
    double coverage = 0.0;
  };

  [[nodiscard]] Figures run(const std::string& sequence, const Arguments& more, const std::string& out = "out") const {
    Arguments arguments = {"run", kData / sequence, "--out", folder_.path() / out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto ran = test::runProgram("wardslam", arguments);
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    const auto evaluated =
        test::runProgram("wardslam", {"eval", "--json", kData / sequence / "groundtruth.txt", trajectory(out)});
    EXPECT_EQ(evaluated.exitCode, 0) << evaluated.err;
    const auto json = nlohmann::json::parse(evaluated.out);
    return {json.at("ate").at("rmse"), json.at("coverage")};
  }
  [[nodiscard]] fs::path trajectory(const std::string& out) const { return folder_.path() / out / "trajectory.txt"; }

  test::TemporaryFolder folder_;
};

TEST_F(Accuracy, OfARealRecordingWithoutPeople) {
  if (!fs::exists(kData / "rpy_walk_static")) GTEST_SKIP() << "not here: " << (kData / "rpy_walk_static");
  const auto figures = run("rpy_walk_static", {"--camera", kFreiburg1, "--filter", "off"});
  EXPECT_LE(figures.ate_m, 0.030);
  EXPECT_GE(figures.coverage, 0.99);
}

TEST_F(Accuracy, OfAWalkingManWithMasksAndAgainTheSame) {
  if (!fs::exists(kData / "rpy_walk")) GTEST_SKIP() << "not here: " << (kData / "rpy_walk");
  const Arguments choice = {"--camera", kFreiburg1, "--masks", kData / "rpy_walk" / "masks", "--deterministic"};
  const auto figures = run("rpy_walk", choice, "once");
  EXPECT_LE(figures.ate_m, 0.030);
  EXPECT_GE(figures.coverage, 0.99);
  EXPECT_EQ(run("rpy_walk", choice, "again").ate_m, figures.ate_m);
  EXPECT_EQ(test::readText(trajectory("once")), test::readText(trajectory("again"))) << "byte by byte";
}

TEST_F(Accuracy, OfAWalkingManWithANetwork) {
  if (!fs::exists(kData / "rpy_walk")) GTEST_SKIP() << "not here: " << (kData / "rpy_walk");
  if (!fs::exists(kNetwork)) GTEST_SKIP() << "not here: " << kNetwork;
  const auto figures = run("rpy_walk", {"--camera", kFreiburg1, "--model", kNetwork});
  EXPECT_LE(figures.ate_m, 0.035);
  EXPECT_GE(figures.coverage, 0.95);
}

TEST_F(Accuracy, OfAWardWithWalkingPeople) {
  if (!fs::exists(kData / "ward_walking")) GTEST_SKIP() << "not here: " << (kData / "ward_walking");
  const auto figures = run("ward_walking", {"--masks", kData / "ward_walking" / "masks"});
  EXPECT_LE(figures.ate_m, 0.030);
  EXPECT_GE(figures.coverage, 0.99);
}

}  // namespace
}  // namespace wardslam
