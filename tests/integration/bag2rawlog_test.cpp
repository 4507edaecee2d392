#include <gmock/gmock.h>

#include <filesystem>
#include <string>

#include "cli_test_support.h"
#include "support/temporary_folder.h"

namespace wardslam {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string data(const std::string& name) { return std::string(WARDSLAM_BAGS_DATA) + "/" + name; }

class Bag2Rawlog : public ::testing::Test {
 protected:
  [[nodiscard]] test::CommandResult convert(const std::string& input, std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments = {input, "-o", output.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return test::runProgram("bag2rawlog", arguments);
  }
  test::TemporaryFolder folder;
  std::filesystem::path output = folder.path() / "out.rawlog";
};

TEST_F(Bag2Rawlog, WritesScansOdometryAndInertia) {
  for (const char* name : {"none.bag", "none.mcap", "sqlite"}) {
    const auto result = convert(data(name));
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(result.out, output.string() + ": 9 observations, 3 of them RGB-D scans\n");
    EXPECT_THAT(result.err, AllOf(HasSubstr("takes colour from /camera/color/image_raw"), HasSubstr("base_link")));
  }
}

TEST_F(Bag2Rawlog, KeepsWhatIsSoundButFails) {
  const auto result = convert(data("unclosed.bag"));
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.out, HasSubstr("2 of them RGB-D scans"));
  EXPECT_THAT(result.err, HasSubstr("cut off"));
}

TEST_F(Bag2Rawlog, NamesATopicThatIsNotThere) {
  const auto result = convert(data("none.bag"), {"--depth", "/nowhere"});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, AllOf(HasSubstr("/nowhere"), HasSubstr("/camera/color/image_raw (sensor_msgs/Image, 3)")));
  EXPECT_FALSE(std::filesystem::exists(output));
}

TEST_F(Bag2Rawlog, TellsOfWhatIsNoRecording) {
  EXPECT_EQ(convert("/no/such.bag").err, "bag2rawlog: /no/such.bag: no such file or folder\n");
  const auto result = convert(folder.write("a.bag", "hello").string());
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, AllOf(StartsWith("bag2rawlog: "), HasSubstr("is no recording of ROS")));
}

TEST_F(Bag2Rawlog, RunTakesARecordingDirectly) {
  const auto result = test::runProgram(
      "wardslam", {"run", data("zstd.mcap"), "--filter", "off", "--out", (folder.path() / "run").string()});
  EXPECT_THAT(result.err, HasSubstr("takes colour from /camera/color/image_raw"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "run/summary.json"));
}

}  // namespace
}  // namespace wardslam
