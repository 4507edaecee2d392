#include <gmock/gmock.h>

#include "integration/cli_test_support.h"
#include "support/temporary_folder.h"

namespace wardslam::test {
namespace {

using testing::HasSubstr;

TEST(KnowledgeCommand, PrintsWhatIsKnown) {
  const auto result = runProgram("wardslam", {"knowledge", "show", "knowledge/hospital.yaml"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("  visitor: person\n"));
  EXPECT_THAT(result.out, HasSubstr("  iv_stand can_be_moved_by patient (strength 0.6, reach 0.5 m)\n"));
}

TEST(KnowledgeCommand, DrawsAPicture) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "hospital.svg";
  const auto result = runProgram("wardslam", {"knowledge", "show", "knowledge/hospital.yaml", "--svg", file.string()});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(readText(file), HasSubstr(">wheelchair</text>"));
}

TEST(KnowledgeCommand, SaysWhatIsWrongWithAFile) {
  const TemporaryFolder folder;
  const auto file = folder.write("ward.yaml", "entities: {cup: [cup]}\nsets: {static: [cupp]}\n");
  const auto wrong = runProgram("wardslam", {"knowledge", "show", file.string()});
  EXPECT_EQ(wrong.exitCode, 1);
  EXPECT_THAT(wrong.err, HasSubstr("ward.yaml:2: "));
  EXPECT_THAT(wrong.err, HasSubstr("did you mean 'cup'"));

  EXPECT_EQ(runProgram("wardslam", {"knowledge", "show", "no/such.yaml"}).exitCode, 1);
  EXPECT_EQ(runProgram("wardslam", {"knowledge"}).exitCode, 2);
}

}  // namespace
}  // namespace wardslam::test
