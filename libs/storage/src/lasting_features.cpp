#include "lasting_features.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include "blob_codecs.h"
#include "map_rows.h"

namespace wardslam::storage {
namespace {

std::vector<odometry::KeyframeId> keyframesWithFeatures(SQLite::Database& database) {
  std::vector<odometry::KeyframeId> ids;
  SQLite::Statement find(database, "SELECT keyframe FROM views ORDER BY keyframe");
  while (find.executeStep()) ColumnReader(find) >> ids.emplace_back();
  return ids;
}

core::Features featuresOf(SQLite::Database& database, odometry::KeyframeId keyframe) {
  SQLite::Statement find(database, "SELECT features FROM views WHERE keyframe = ?");
  ParameterBinder(find) << keyframe;
  core::Bytes blob;
  if (find.executeStep()) ColumnReader(find) >> blob;
  return decodeFeatures(blob);
}

/// From the number of a key point to its number among those that last.
std::map<std::size_t, std::size_t> lastingOf(const std::vector<odometry::Sighting>& sightings, std::size_t keypoints) {
  std::map<std::size_t, std::size_t> lasting;
  for (const auto& sighting : sightings) {
    if (sighting.keypoint >= keypoints) throw core::BlobError("a sighting names a key point that is not there");
    lasting[sighting.keypoint] = 0;
  }
  std::size_t next = 0;
  for (auto& [before, after] : lasting) after = next++;
  return lasting;
}

core::Features selected(const core::Features& all, const std::map<std::size_t, std::size_t>& lasting) {
  core::Features some;
  some.descriptors.create(static_cast<int>(lasting.size()), all.descriptors.cols, all.descriptors.type());
  for (const auto& [before, after] : lasting) {
    some.keypoints.push_back(all.keypoints[before]);
    all.descriptors.row(static_cast<int>(before)).copyTo(some.descriptors.row(static_cast<int>(after)));
  }
  return some;
}

}  // namespace

Sightings keepLastingFeatures(SQLite::Database& database, const Sightings& sightings) {
  SQLite::Statement update(database, "UPDATE views SET features = ? WHERE keyframe = ?");
  Sightings renumbered = sightings;
  for (const odometry::KeyframeId keyframe : keyframesWithFeatures(database)) {
    const core::Features all = featuresOf(database, keyframe);
    auto& ofKeyframe = renumbered[keyframe];
    const auto lasting = lastingOf(ofKeyframe, all.size());
    if (lasting.size() == all.size()) continue;
    (ParameterBinder(update) << encodeFeatures(selected(all, lasting)) << keyframe).run();
    for (auto& sighting : ofKeyframe) sighting.keypoint = lasting.at(sighting.keypoint);
  }
  return renumbered;
}

}  // namespace wardslam::storage
