#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli_test_support.h"
#include "room_recording.h"

namespace wardslam {
namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

constexpr int kImages = 5;

class DynamicTruth : public ::testing::Test {
 protected:
  /// `wardslam run <room> --out <out> …`
  [[nodiscard]] test::CommandResult run(const Arguments& more) const {
    Arguments arguments = {"run", room.path(), "--out", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::runProgram("wardslam", arguments);
  }
  [[nodiscard]] nlohmann::json summary() const { return nlohmann::json::parse(test::readText(out / "summary.json")); }

  /// A folder with the first mask under another name.
  [[nodiscard]] fs::path truth(const std::string& name, const std::string& stamp) const {
    fs::create_directories(folder.path() / name);
    fs::copy(room.masks() / "1000.000000.png", folder.path() / name / (stamp + ".png"));
    return folder.path() / name;
  }
  void expectError(const fs::path& truth, const std::string& part) const {
    const auto result = run({"--filter", "off", "--dynamic-truth", truth});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_THAT(result.err, ::testing::HasSubstr(part));
  }

  test::TemporaryFolder folder;
  test::RoomRecording room{kImages};
  const fs::path out = folder.path() / "results";
};

TEST_F(DynamicTruth, IsComparedWithWhatIsMarked) {
  // What the masks call a person is what moves: 80 columns, which the margin makes 83.
  ASSERT_EQ(run({"--masks", room.masks(), "--dynamic-truth", room.masks()}).exitCode, 0);
  const auto dynamic = summary().at("dynamic");
  EXPECT_EQ(dynamic.at("frames"), kImages);
  EXPECT_NEAR(dynamic.at("pixels").at("precision").get<double>(), 80.0 / 83.0, 1e-9);
  EXPECT_EQ(dynamic.at("pixels").at("recall"), 1.0);
  EXPECT_NEAR(dynamic.at("pixels").at("spared").get<double>(), 237.0 / 240.0, 1e-9);
  EXPECT_EQ(dynamic.at("keypoints").at("recall"), 1.0);
  EXPECT_GT(dynamic.at("keypoints").at("true_negatives").get<int>(), 0);
}

TEST_F(DynamicTruth, WhereNothingIsMarkedThereIsNoPrecision) {
  ASSERT_EQ(run({"--filter", "off", "--dynamic-truth", room.masks()}).exitCode, 0);
  EXPECT_TRUE(summary().at("dynamic").at("pixels").at("precision").is_null());
  EXPECT_EQ(summary().at("dynamic").at("pixels").at("recall"), 0.0);
}

TEST_F(DynamicTruth, ThatDoesNotFitIsAnError) {
  expectError(folder.path() / "nowhere", "nowhere");
  expectError(truth("other", "5.000000"), "stamps");
  const fs::path small = truth("small", "1000.000000");
  test::shrinkImage(small / "1000.000000.png");
  expectError(small, "160x120");
}

}  // namespace
}  // namespace wardslam
