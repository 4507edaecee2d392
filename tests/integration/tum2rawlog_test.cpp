#include <gmock/gmock.h>

#include <filesystem>
#include <string>

#include "cli_test_support.h"
#include "sources/tum_folder_writer.h"

namespace wardslam {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class Tum2Rawlog : public ::testing::Test {
 protected:
  [[nodiscard]] test::CommandResult convert() const {
    return test::runProgram("tum2rawlog", {sequence.path().string(), "-o", output.string()});
  }
  test::TumFolder sequence{3};
  test::TemporaryFolder folder;
  std::filesystem::path output = folder.path() / "out.rawlog";
};

TEST_F(Tum2Rawlog, WritesOneObservationPerPair) {
  const auto result = convert();
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.out, output.string() + ": 3 observations\n");
  EXPECT_THAT(result.err, IsEmpty());
  EXPECT_GT(std::filesystem::file_size(output), 3U * 32 * 24);
}

TEST_F(Tum2Rawlog, KeepsWhatIsSoundButFails) {
  std::filesystem::remove(sequence.path() / test::TumFolder::depthFile(1));
  const auto result = convert();
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_EQ(result.out, output.string() + ": 2 observations\n");
  EXPECT_THAT(result.err, HasSubstr("depth/1.png is missing"));
  EXPECT_TRUE(std::filesystem::exists(output));
}

TEST_F(Tum2Rawlog, LeavesNothingBehindWhereNothingCanBeRead) {
  for (int i = 0; i < 3; ++i) std::filesystem::remove(sequence.path() / test::TumFolder::colorFile(i));
  EXPECT_EQ(convert().exitCode, 1);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST_F(Tum2Rawlog, TellsOfAMissingFolder) {
  const auto result = test::runProgram("tum2rawlog", {"/no/such/folder", "-o", output.string()});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_EQ(result.err, "tum2rawlog: /no/such/folder: no such file or folder\n");
}

TEST_F(Tum2Rawlog, TellsOfWrongUsage) {
  const auto result = test::runProgram("tum2rawlog", {sequence.path().string()});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.err, AllOf(StartsWith("tum2rawlog: "), HasSubstr("--output")));
}

}  // namespace
}  // namespace wardslam
