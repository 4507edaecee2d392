#include <gmock/gmock.h>

#include <algorithm>

#include "cli_test_support.h"

namespace wardslam {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

test::CommandResult config(const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = {"config"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return test::runProgram("wardslam", arguments);
}

TEST(ConfigCommand, TheFileThatShipsIsWhatItPrints) {
  const auto result = config();
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.out, test::readText(fs::path(WARDSLAM_CONFIG_DIR) / "wardslam.yaml"))
      << "write it anew: wardslam config > config/wardslam.yaml";
}

TEST(ConfigCommand, PrintsAFileCompletedByTheDefaults) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("my.yaml", "features: {key_points: 700}\nfilters: []\n");
  const auto result = config({file});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("  key_points: 700  # [50, 20000] count"), HasSubstr("\nodometry:\n"),
                                HasSubstr("\nfilters: []\n")));
  const auto again = config({folder.write("again.yaml", result.out)});
  EXPECT_EQ(again.out, result.out);
}

TEST(ConfigCommand, TellsWhatIsWrong) {
  const test::TemporaryFolder folder;
  for (const auto& [text, complaint] : std::vector<std::pair<std::string, std::string>>{
           {"features:\n  levls: 4\n", "my.yaml:2: 'features.levls': unknown key; did you mean 'levels'?"},
           {"filters: [{class_name: 'wardslam::filters::SemanticDynamicFiler'}]\n",
            "did you mean 'wardslam::filters::SemanticDynamicFilter'"},
           {"knowledge: {file: none.yaml}\n", "none.yaml"}}) {
    const auto result = config({folder.write("my.yaml", text)});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_THAT(result.out, IsEmpty());
    EXPECT_THAT(result.err, HasSubstr(complaint));
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  }
}

}  // namespace
}  // namespace wardslam
