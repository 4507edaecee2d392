#include <gmock/gmock.h>

#include "integration/cli_test_support.h"
#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::test {
namespace {

using testing::HasSubstr;

class MapExportCommandTest : public testing::Test {
 protected:
  MapExportCommandTest() { storage::MapFile::create(map_).write(storage::everythingOf(makeWard())); }
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  TemporaryFolder folder_;
  std::string map_ = path("ward.wardmap");
};

TEST_F(MapExportCommandTest, WritesEveryFormatThatIsNamedAndNamesWhatItWrote) {
  const auto result =
      runProgram("wardslam", {"map", "export", map_, "--ply", path("a.ply"), "--pcd", path("a.pcd"), "--octomap",
                              path("a.bt"), "--scene", path("a.3Dscene"), "--gridmap", path("a.gridmap"), "--ros-map",
                              path("a.yaml"), "--geojson", path("a.geojson"), "--csv", path("a.csv")});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.err, "");
  std::string expected;
  for (const char* name : {"a.ply", "a.pcd", "a.bt", "a.3Dscene", "a.gridmap", "a.yaml", "a.geojson", "a.csv"}) {
    expected += path(name) + "\n";
    EXPECT_GT(std::filesystem::file_size(path(name)), 0U) << name;
  }
  EXPECT_EQ(result.out, expected);
  EXPECT_TRUE(std::filesystem::exists(path("a.pgm")));
}

TEST_F(MapExportCommandTest, SaysWhatIsMissing) {
  EXPECT_EQ(runProgram("wardslam", {"map", "export", map_}).exitCode, 2);
  const auto result = runProgram("wardslam", {"map", "export", map_, "--ply", path("missing/a.ply")});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, HasSubstr("cannot be created"));
}

}  // namespace
}  // namespace wardslam::test
