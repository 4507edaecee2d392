#include "map_check.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>

#include <string>
#include <utility>
#include <vector>

#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::storage {
namespace {

using testing::HasSubstr;

class MapCheckTest : public testing::Test {
 protected:
  /// The hand-made ward, changed by a statement of SQL.
  MapFile damagedWard(const std::string& sql) {
    const auto ward = test::makeWard();
    {
      MapChanges changes = everythingOf(ward);
      for (const odometry::KeyframeId id : {1, 2}) changes.views.push_back(test::makeView(id, ward));
      MapFile::create(path_, {ward.labels, ""}).write(changes);
    }
    SQLite::Database(path_.string(), SQLite::OPEN_READWRITE).exec(sql);
    return MapFile::open(path_);
  }

  test::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "ward.wardmap";
};

TEST_F(MapCheckTest, FindsWhatIsOutOfBounds) {
  const std::vector<std::pair<std::string, std::string>> damages = {
      {"UPDATE keyframes SET x_m = 1e308 WHERE id = 2", "x_m is impossible"},
      {"UPDATE keyframes SET x_m = 'abc' WHERE id = 2", "x_m is impossible"},
      {"UPDATE keyframes SET qw = 1e300 WHERE id = 2", "qw is impossible"},
      {"UPDATE keyframes SET stamp_s = -1e18 WHERE id = 2", "stamp_s is impossible"},
      {"UPDATE cameras SET fx_px = 0", "fx_px is impossible"},
      {"UPDATE cameras SET fy_px = 1e-300", "fy_px is impossible"},
      {"UPDATE cameras SET fx_px = -525", "fx_px is impossible"},
      {"UPDATE cameras SET cx_px = 1e300", "cx_px is impossible"},
      {"UPDATE cameras SET k1 = 1e300", "k1 is impossible"},
      {"UPDATE cameras SET width_px = -640", "width_px is impossible"},
      {"UPDATE cameras SET height_px = 100000", "height_px is impossible"},
      {"UPDATE points SET y_m = 1e300", "y_m is impossible"},
      {"UPDATE zone_corners SET x_m = 1e300", "x_m is impossible"},
      {"UPDATE floor_plan SET resolution_m = 1e-9", "resolution_m is impossible"},
      {"UPDATE floor_plan SET resolution_m = 1e9", "resolution_m is impossible"},
      {"UPDATE floor_plan SET origin_x_m = 1e308", "origin_x_m is impossible"},
      {"UPDATE objects SET centroid_x_m = 1e308 WHERE id = 3", "centroid_x_m is impossible"},
      {"UPDATE objects SET probability = 7 WHERE id = 3", "probability is impossible"},
      {"UPDATE objects SET last_seen_s = -1e18 WHERE id = 3", "last_seen_s is impossible"},
      {"UPDATE objects SET box_width_m = -1 WHERE id = 3", "negative size"},
      {"UPDATE objects SET min_z_m = max_z_m + 1 WHERE id = 3; DELETE FROM object_boxes WHERE id = 3; INSERT INTO "
       "object_boxes SELECT id, min_x_m, max_x_m, min_y_m, max_y_m, max_z_m, min_z_m FROM objects WHERE id = 3",
       "inside out"},
      {"UPDATE views SET stretch = -1 WHERE keyframe = 2", "impossible stretch"}};
  for (const auto& [sql, complaint] : damages) {
    EXPECT_THAT(damagedWard(sql).check(), testing::Contains(HasSubstr(complaint))) << sql;
  }
}

TEST_F(MapCheckTest, WhatIsOutOfBoundsIsNotReadEither) {
  for (const char* sql : {"UPDATE keyframes SET x_m = 1e308 WHERE id = 2", "UPDATE floor_plan SET resolution_m = 1e-9",
                          "UPDATE objects SET centroid_x_m = 1e308 WHERE id = 3"}) {
    const auto file = damagedWard(sql);
    EXPECT_THROW((void)file.read(), core::InputError) << sql;
  }
  for (const char* sql : {"UPDATE cameras SET fx_px = 0", "UPDATE cameras SET width_px = -640"}) {
    const auto file = damagedWard(sql);
    EXPECT_THROW((void)file.readViews(), core::InputError) << sql;
  }
}

}  // namespace
}  // namespace wardslam::storage
