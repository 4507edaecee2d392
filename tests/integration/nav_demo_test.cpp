#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "integration/cli_test_support.h"

namespace wardslam::test {
namespace {

using testing::HasSubstr;

/// A few seconds of the synthetic ward, mapped: what the robot drives by.
class NavDemo : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    const auto recorded = runProgram("rawlog-synth", {"-o", path("ward.rawlog"), "--seconds", "6", "--rate", "8",
                                                      "--width", "320", "--height", "240"});
    ASSERT_EQ(recorded.exitCode, 0) << recorded.err;
    const auto mapped = runProgram("wardslam", {"run", path("ward.rawlog"), "--masks", path("ward_labels/masks"),
                                                "--deterministic", "--out", path("run")});
    ASSERT_EQ(mapped.exitCode, 0) << mapped.err;
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static std::string path(const std::string& name) { return (folder_->path() / name).string(); }
  static CommandResult deliver(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), path("run/map.wardmap"));
    return runProgram("wardslam-nav-demo", arguments);
  }

  static inline std::unique_ptr<TemporaryFolder> folder_;
};

TEST_F(NavDemo, DeliversInTheTrueWorldByTheMapAlone) {
  const auto result = deliver({"--to", "bed 2", "--start", "1.6", "0.9", "--truth", path("ward.rawlog"), "--runs", "2",
                               "--json", "--picture", path("run.jpg")});
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["runs"].size(), 2U);
  for (const auto& run : json["runs"]) {
    EXPECT_TRUE(run["arrived"]);
    EXPECT_EQ(run["contacts_things"], 0);
    EXPECT_LT(run["goal_error_m"], 0.2);
    EXPECT_GT(run["nearest_thing_m"], 0.1);
  }
  EXPECT_EQ(result.exitCode == 0, json["good_runs"] == 2);
  EXPECT_THAT(json["truth"].get<std::string>(), HasSubstr("ward.rawlog"));
  EXPECT_FALSE(cv::imread(path("run.jpg")).empty());
  EXPECT_FALSE(std::filesystem::exists("ReacNavGrid_000.dat.gz")) << "tables of the navigator, left where it was run";
}

TEST_F(NavDemo, TheSameSeedGivesTheSameAnswer) {
  const std::vector<std::string> arguments = {"--to", "bed 1", "--truth", path("ward.rawlog"), "--seed", "4", "--json"};
  EXPECT_EQ(deliver(arguments).out, deliver(arguments).out);
}

TEST_F(NavDemo, SaysWhatIsWrong) {
  const auto nothing = deliver({"--to", "bed 99"});
  EXPECT_EQ(nothing.exitCode, 1);
  EXPECT_THAT(nothing.err, HasSubstr("holds no 'bed 99'"));
  const auto noTruth = deliver({"--to", "bed 1", "--truth", path("elsewhere.rawlog")});
  EXPECT_EQ(noTruth.exitCode, 1);
  EXPECT_THAT(noTruth.err, HasSubstr("floor.yaml: is missing"));
  EXPECT_EQ(deliver({}).exitCode, 2);
  std::ofstream(path("zones.yaml")) << "zones: [{name: everywhere, polygon: [[-9, -9], [9, -9], [9, 9], [-9, 9]]}]\n";
  const auto closed = deliver({"--to", "bed 1", "--zones", path("zones.yaml"), "--forbid", "everywhere"});
  EXPECT_EQ(closed.exitCode, 1);
  EXPECT_THAT(closed.err, HasSubstr("forbidden zone 'everywhere'"));
}

}  // namespace
}  // namespace wardslam::test
