#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "cli_test_support.h"
#include "support/temporary_folder.h"
#include "wardslam/exchange/tum_trajectory.h"

/// From the pairs of a stereo camera to a trajectory.
namespace wardslam {
namespace {

double lengthOf_m(const core::Trajectory& way) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    length_m += (way[i].T_map_cam.translation() - way[i - 1].T_map_cam.translation()).norm();
  }
  return length_m;
}

TEST(Stereo, AWardIsTrackedAmongWalkingPeople) {
  const test::TemporaryFolder folder;
  const auto at = [&](const std::string& name) { return (folder.path() / name).string(); };
  const auto rendering = test::runProgram("rawlog-synth", {"--stereo", "--seconds", "5", "--rate", "10", "--width",
                                                           "320", "--height", "240", "-o", at("ward.rawlog")});
  ASSERT_EQ(rendering.exitCode, 0) << rendering.err;
  const auto ran = test::runProgram("wardslam", {"run", at("ward.rawlog"), "--masks", at("ward_labels/masks"),
                                                 "--deterministic", "--out", at("out")});
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  const auto evaluated =
      test::runProgram("wardslam", {"eval", "--json", at("ward.groundtruth.txt"), at("out/trajectory.txt")});
  const auto figures = nlohmann::json::parse(evaluated.out);
  EXPECT_EQ(figures.at("coverage"), 1.0);

  // A baseline or focal length wrong by a tenth would leave 4 cm on this way.
  ASSERT_GT(lengthOf_m(exchange::readTumTrajectory(at("ward.groundtruth.txt"))), 1.5);
  EXPECT_LE(figures.at("ate").at("rmse"), 0.02);
}

}  // namespace
}  // namespace wardslam
