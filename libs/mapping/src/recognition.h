#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "detections.h"
#include "object_database.h"
#include "semantic_cloud.h"
#include "view_samples.h"
#include "wardslam/knowledge/motion_rules.h"

namespace wardslam::mapping {

/// What a view shows, and what of it the cloud knows.
struct Recognition {
  const std::vector<Sample>& samples;
  const std::vector<std::optional<PointRef>>& points;  ///< That the samples see again.
  const std::vector<Detection>& detections;
  const std::map<ObjectId, std::size_t>& inSight;  ///< Points of each object.
};

/// The detections as the database sees them. Of those of `movable` classes that fall on nothing known it is found out
/// whether their places, up to `range_m` from keyframes, were seen to be empty before.
[[nodiscard]] std::vector<Evidence> evidenceOf(const Recognition& seen, const SemanticCloud& cloud,
                                               const knowledge::ClassSet& movable, double range_m);

}  // namespace wardslam::mapping
