#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <string>

#include "integration/cli_test_support.h"
#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::test {
namespace {

using testing::HasSubstr;

/// The hand-made ward: a room on either side of its wall, the gap at its end a passage.
class EvalRoomsCommand : public testing::Test {
 protected:
  [[nodiscard]] CommandResult evalRooms(std::vector<std::string> options) const {
    const auto map = (folder_.path() / "ward.wardmap").string();
    storage::MapFile::create(map).write(storage::everythingOf(makeWard()));
    options.insert(options.begin(), {"eval-rooms", truth_, map});
    return runProgram("wardslam", options);
  }

  TemporaryFolder folder_;
  const std::string truth_ = folder_.write("rooms.geojson",
                                           R"({"features": [
          {"properties": {"what": "room", "id": "a", "name": "A"},
           "geometry": {"coordinates": [[[-1, -1], [3.1, -1], [3.1, 5], [-1, 5]]]}},
          {"properties": {"what": "room", "id": "b", "name": "B"},
           "geometry": {"coordinates": [[[3.1, -1], [7, -1], [7, 5], [3.1, 5]]]}},
          {"properties": {"what": "door", "rooms": ["a", "b"], "state": "passage", "open_rad": 0},
           "geometry": {"coordinates": [[3.1, 4], [3.1, 5]]}}]})");
};

TEST_F(EvalRoomsCommand, TellsWhatWasFound) {
  const auto result = evalRooms({"--json"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json.at("rooms"), 2);
  EXPECT_EQ(json.at("rooms_found"), 2);
  EXPECT_EQ(json.at("doors"), 1);
  EXPECT_EQ(json.at("doors_found"), 1);
  EXPECT_EQ(json.at("precision"), 1.0);
  EXPECT_EQ(json.at("each").at(0).at("name"), "A");
  EXPECT_EQ(json.at("each").at(0).at("room"), "clean zone");
}

TEST_F(EvalRoomsCommand, PrintsATable) {
  const auto result = evalRooms({});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("rooms       2    2    1.00"));
}

TEST_F(EvalRoomsCommand, APassageWiderThanADoorMakesThemOne) {
  const auto result = evalRooms({"--json", "--widest-door", "0.6"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json.at("rooms"), 1) << "1 m, as it was built";
  EXPECT_EQ(json.at("rooms_found"), 1) << "0.9 m, as the map has it";
}

TEST_F(EvalRoomsCommand, ATrajectoryNeedsTheTruePoses) { EXPECT_EQ(evalRooms({"--trajectory", "t.txt"}).exitCode, 2); }

}  // namespace
}  // namespace wardslam::test
