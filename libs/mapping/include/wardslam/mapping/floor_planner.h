#pragma once

#include "wardslam/mapping/floor_plan.h"
#include "wardslam/mapping/semantic_map.h"

namespace wardslam::mapping {

/// Section `mapping.floor_plan:` of the configuration.
struct FloorPlanOptions {
  double resolution_m = 0.05;
  double min_height_m = 0.10;
  double max_height_m = 1.80;
  double max_range_m = 4.0;
  int min_points = 2;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("resolution_m", self.resolution_m, {0.01, 0.5}, "m", "side of a cell");
    visit("min_height_m", self.min_height_m, {0.0, 1.0}, "m", "a robot drives over what is lower");
    visit("max_height_m", self.max_height_m, {0.1, 3.0}, "m", "and under what is higher");
    visit("max_range_m", self.max_range_m, {0.5, 20.0}, "m", "how far a keyframe tells that the floor is free");
    visit("min_points", self.min_points, {1, 100}, "count", "points of the cloud that make a cell occupied");
  }
};

/// The floor plan of a map: occupied where the cloud has points between the heights over the floor that keyframes saw
/// nearby, free where keyframes saw so, unknown elsewhere. Ramps belong to the floor, stairs do not. Where no keyframe
/// saw a floor, it is taken to be at z = 0. Of storeys one above the other it is the one with most keyframes. Empty for
/// a map without keyframes.
[[nodiscard]] FloorPlan drawFloorPlan(const SemanticMap& map, const FloorPlanOptions& options);

}  // namespace wardslam::mapping
