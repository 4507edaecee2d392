#include "wardslam/core/data_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"

namespace wardslam::core {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

class DataFilesTest : public testing::Test {
 protected:
  DataFilesTest() {
    for (const char* place : {"beside", "chosen"}) folder_.write(std::string(place) + "/data.yaml", "{}");
  }
  ~DataFilesTest() override { unsetenv("WARDSLAM_DATA_DIR"); }

  void choose(const fs::path& place) const { setenv("WARDSLAM_DATA_DIR", (folder_.path() / place).c_str(), 1); }

  test::TemporaryFolder folder_;
};

TEST_F(DataFilesTest, AbsolutePathIsTakenAsItIs) {
  const fs::path file = folder_.path() / "beside" / "data.yaml";
  EXPECT_EQ(findDataFile(file, "/elsewhere/config.yaml"), file);
  EXPECT_THAT([] { return findDataFile("/nowhere/data.yaml"); },
              ThrowsMessage<InputError>(HasSubstr("/nowhere/data.yaml: no such file")));
}

TEST_F(DataFilesTest, NeighbourOfTheReferringFileComesFirst) {
  choose("chosen");
  EXPECT_EQ(findDataFile("data.yaml", folder_.path() / "beside" / "config.yaml"),
            folder_.path() / "beside" / "data.yaml");
  EXPECT_EQ(findDataFile("data.yaml"), folder_.path() / "chosen" / "data.yaml");
}

TEST_F(DataFilesTest, ShippedFileIsFoundWithoutHelp) {
  EXPECT_TRUE(fs::exists(findDataFile("knowledge/hospital.yaml")));
}

TEST_F(DataFilesTest, MissingFileListsThePlacesTried) {
  choose("chosen");
  EXPECT_THAT([&] { return findDataFile("none.yaml", folder_.path() / "beside" / "config.yaml"); },
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr("none.yaml: not found in"), HasSubstr((folder_.path() / "beside").string()),
                        HasSubstr((folder_.path() / "chosen").string()), HasSubstr("WARDSLAM_DATA_DIR"))));
}

TEST(FindProgram, LooksBesideTheLibraryAndLeavesTheRestToThePath) {
  EXPECT_EQ(findProgram("/a/b"), "/a/b");
  EXPECT_EQ(findProgram("./b"), "./b");
  EXPECT_EQ(findProgram("no-such-program"), "no-such-program");
  EXPECT_TRUE(findProgram("test_core").has_parent_path());  // this program lies beside the others
}

}  // namespace
}  // namespace wardslam::core
