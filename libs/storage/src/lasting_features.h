#pragma once

#include <SQLiteCpp/Database.h>

#include <map>
#include <vector>

#include "wardslam/odometry/keyframe.h"

namespace wardslam::storage {

using Sightings = std::map<odometry::KeyframeId, std::vector<odometry::Sighting>>;

/// Erases from the file all key points that show none of the points sighted in the end: what was seen once and never
/// again serves no one, and may be of somebody who walked by. Returns the sightings with their key points numbered as
/// they are in the file from then on. A keyframe that loses none stays as it is, to the last byte. Throws
/// SQLite::Exception, core::BlobError.
[[nodiscard]] Sightings keepLastingFeatures(SQLite::Database& database, const Sightings& sightings);

}  // namespace wardslam::storage
