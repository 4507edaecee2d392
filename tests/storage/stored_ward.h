#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "support/complaint.h"
#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::storage {

/// The hand-made ward, and a file for it.
class StoredWard : public testing::Test {
 protected:
  /// With what its three keyframes saw.
  MapFile writeWard() const {
    MapFile file = MapFile::create(path_, {ward_.labels, "features:\n  key_points: 1000\n"});
    MapChanges changes = everythingOf(ward_);
    for (const auto& [id, keyframe] : ward_.keyframes) changes.views.push_back(test::makeView(id, ward_));
    changes.loops = {{1, 3, Eigen::Isometry3d(Eigen::Translation3d(1, 2, 3))}};
    file.write(changes);
    return file;
  }
  void runSql(const std::string& sql) const { SQLite::Database(path_.string(), SQLite::OPEN_READWRITE).exec(sql); }
  std::string openingError(MapAccess access = MapAccess::Read) const {
    return test::complaintOf([&] { return MapFile::open(path_, access).read(); });
  }

  test::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "ward.wardmap";
  mapping::SemanticMap ward_ = test::makeWard();
};

}  // namespace wardslam::storage
