#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "wardslam/mapping/semantic_map.h"

namespace wardslam::query {

/// Brings a thing into another frame, of which `T_other_map` says how the map lies in it. Its box parallel to the axes
/// is then around the oriented one.
void moveObject(mapping::MapObject& object, const Eigen::Isometry3d& T_other_map);

/// What changed from one map to another of the same place, both in the same map frame.
struct MapDifference {
  struct Moved {
    const mapping::MapObject* before = nullptr;
    const mapping::MapObject* after = nullptr;
    double distance_m = 0.0;  ///< Between the centroids.
  };

  std::vector<Moved> moved;
  std::vector<const mapping::MapObject*> gone;   ///< Only in the first.
  std::vector<const mapping::MapObject*> added;  ///< Only in the second.
  std::size_t unchanged = 0;
};

/// Pairs objects of one class one to one, the nearest first; a pair that stands less than `tolerance_m` apart is
/// unchanged, a pair further apart has moved. Objects in state Gone count as absent. The result points into the maps.
[[nodiscard]] MapDifference difference(const mapping::SemanticMap& before, const mapping::SemanticMap& after,
                                       double tolerance_m = 0.3);

}  // namespace wardslam::query
