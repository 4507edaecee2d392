#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "wardslam/mapping/floor_plan.h"

namespace wardslam::evaluation {

/// What a rigid motion in space does to the floor, seen from above.
[[nodiscard]] Eigen::Isometry2d onFloor(const Eigen::Isometry3d& T);

/// How well a floor plan tells where the floor is free. Areas in m², of truly free floor except where said otherwise.
struct FloorPlanEvaluation {
  double free_m2 = 0.0;         ///< Called free.
  double occupied_m2 = 0.0;     ///< Called occupied: a robot goes around nothing.
  double unknown_m2 = 0.0;      ///< Not known to the plan.
  double wronglyFree_m2 = 0.0;  ///< Called free where it is not: a robot runs into something.

  /// Free floor in both, over free floor in either, where the plan knows something. NaN when there is none.
  [[nodiscard]] double intersectionOverUnion() const;
  /// Share of the truly free floor that the plan knows. NaN when there is none.
  [[nodiscard]] double knownShare() const;
};

/// The truth with only that floor called free which is connected with one of the places (m, its frame); what else was
/// free, inside walls, cupboards and beyond, becomes unknown. Places outside or not free are left out.
[[nodiscard]] mapping::FloorPlan reachableFloor(const mapping::FloorPlan& truth,
                                                const std::vector<Eigen::Vector2d>& places_m);

/// Compares cell by cell, each plan at its own resolution. Whatever the truth does not call free, and what lies beyond
/// it, is not free. `T_truth_map` takes places of the found plan into the frame of the truth.
[[nodiscard]] FloorPlanEvaluation evaluateFloorPlan(const mapping::FloorPlan& truth, const mapping::FloorPlan& found,
                                                    const Eigen::Isometry2d& T_truth_map);

}  // namespace wardslam::evaluation
