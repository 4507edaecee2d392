#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "integration/cli_test_support.h"
#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/exchange/map_export.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::test {
namespace {

/// The true floor of the hand-made ward, of which the gap at the end of the wall is 1 m wide. The map's frame lies 10 m
/// aside; in it a box of 1 m² stands where there is none.
class EvalFloorCommand : public testing::Test {
 protected:
  EvalFloorCommand() {
    auto ward = makeWard();
    exchange::exportRosMap(ward, path("truth.yaml"));
    for (auto& [id, keyframe] : ward.keyframes) keyframe.T_map_cam.pretranslate(Eigen::Vector3d(10, 0, 0));
    ward.floorPlan.origin_m.x() += 10;
    ward.floorPlan.cells(cv::Rect(20, 20, 20, 20)).setTo(mapping::FloorPlan::kOccupied);
    storage::MapFile::create(path("ward.wardmap")).write(storage::everythingOf(ward));
  }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  [[nodiscard]] CommandResult evalFloor(const std::string& map, const std::string& option) const {
    return runProgram("wardslam", {"eval-floor", path("truth.yaml"), map, "--trajectory", trajectory_, "--ground-truth",
                                   groundTruth_, option});
  }

  TemporaryFolder folder_;
  const std::string groundTruth_ =
      folder_.write("groundtruth.txt", "0.0 1 0 0 0 0 0 1\n0.1 0 1 0 0 0 0 1\n0.2 0 0 1 0 0 0 1\n");
  const std::string trajectory_ =
      folder_.write("trajectory.txt", "0.0 11 0 0 0 0 0 1\n0.1 10 1 0 0 0 0 1\n0.2 10 0 1 0 0 0 1\n");
};

TEST_F(EvalFloorCommand, TellsWhatIsWrongWithTheFreeFloor) {
  const auto result = evalFloor(path("ward.wardmap"), "--json");
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  const double free_m2 = 8 * 5.9 - 0.2 * 5;  // without the wall, and the strip that is unknown in the truth
  EXPECT_NEAR(json.at("free_m2").get<double>(), free_m2 - 1.0, 0.05);
  EXPECT_NEAR(json.at("occupied_m2").get<double>(), 1.0, 0.05);
  EXPECT_NEAR(json.at("wrongly_free_m2").get<double>(), 0.0, 0.05);
  EXPECT_NEAR(json.at("intersection_over_union").get<double>(), (free_m2 - 1.0) / free_m2, 0.002);
}

TEST_F(EvalFloorCommand, SaysSoWhereTheMapHasNoFloorPlan) {
  const auto empty = path("empty.wardmap");
  { const auto file = storage::MapFile::create(empty); }
  const auto result = evalFloor(empty, "--json");
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, testing::HasSubstr("the map has no floor plan"));
}

}  // namespace
}  // namespace wardslam::test
