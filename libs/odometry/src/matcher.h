#pragma once

#include <cstddef>
#include <vector>

#include "keypoint_grid.h"
#include "local_map.h"

namespace wardslam::odometry {

/// A map point and the key point in which it was recognised.
struct Match {
  PointId point = 0;
  std::size_t keypoint = 0;
};

/// Recognises map points in an image by their ORB descriptors.
class Matcher {
 public:
  explicit Matcher(const MatcherOptions& options) : options_(options) {}

  /// Looks for each projected point within `radius_px` × its scale around where it should be. A key point is given
  /// to the point that resembles it most.
  [[nodiscard]] std::vector<Match> searchNear(const std::vector<ProjectedPoint>& points, const core::Features& features,
                                              const KeypointGrid& grid, double radius_px) const;

  /// Looks for the points everywhere in the image: mutual best matches that pass the ratio test.
  [[nodiscard]] std::vector<Match> searchEverywhere(const std::vector<PointId>& ids, const LocalMap& map,
                                                    const core::Features& features) const;

 private:
  MatcherOptions options_;
};

}  // namespace wardslam::odometry
