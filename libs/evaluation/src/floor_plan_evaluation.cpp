#include "wardslam/evaluation/floor_plan_evaluation.h"

#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

namespace wardslam::evaluation {
namespace {

using mapping::FloorPlan;

double ratio(double part, double whole) {
  return whole > 0.0 ? part / whole : std::numeric_limits<double>::quiet_NaN();
}

cv::Point cellAt(const FloorPlan& plan, const Eigen::Vector2d& p_m) {
  const Eigen::Vector2d cell = ((p_m - plan.origin_m) / plan.resolution_m).array().floor();
  return {static_cast<int>(cell.x()), static_cast<int>(cell.y())};
}

/// Unknown beyond its border.
unsigned char valueAt(const FloorPlan& plan, const Eigen::Vector2d& p_m) {
  const cv::Point cell = cellAt(plan, p_m);
  const bool isInside = cell.inside(cv::Rect({0, 0}, plan.cells.size()));
  return isInside ? plan.cells.at<unsigned char>(cell) : FloorPlan::kUnknown;
}

/// Calls `take` with the centre (m) of every free cell.
template <class Take>
void forEachFreeCell(const FloorPlan& plan, const Take& take) {
  for (int row = 0; row < plan.cells.rows; ++row) {
    for (int column = 0; column < plan.cells.cols; ++column) {
      if (plan.cells.at<unsigned char>(row, column) != FloorPlan::kFree) continue;
      take(Eigen::Vector2d(plan.origin_m + plan.resolution_m * Eigen::Vector2d(column + 0.5, row + 0.5)));
    }
  }
}

}  // namespace

Eigen::Isometry2d onFloor(const Eigen::Isometry3d& T) {
  return Eigen::Translation2d(T.translation().head<2>()) * Eigen::Rotation2Dd(std::atan2(T(1, 0), T(0, 0)));
}

double FloorPlanEvaluation::intersectionOverUnion() const {
  return ratio(free_m2, free_m2 + occupied_m2 + wronglyFree_m2);
}

double FloorPlanEvaluation::knownShare() const {
  return ratio(free_m2 + occupied_m2, free_m2 + occupied_m2 + unknown_m2);
}

FloorPlan reachableFloor(const FloorPlan& truth, const std::vector<Eigen::Vector2d>& places_m) {
  constexpr unsigned char kReached = 1;
  cv::Mat cells = truth.cells.clone();
  for (const Eigen::Vector2d& place_m : places_m) {
    if (valueAt(truth, place_m) == FloorPlan::kFree) cv::floodFill(cells, cellAt(truth, place_m), kReached);
  }
  cells.setTo(FloorPlan::kUnknown, cells == FloorPlan::kFree);
  cells.setTo(FloorPlan::kFree, cells == kReached);
  return {cells, truth.resolution_m, truth.origin_m};
}

FloorPlanEvaluation evaluateFloorPlan(const FloorPlan& truth, const FloorPlan& found,
                                      const Eigen::Isometry2d& T_truth_map) {
  FloorPlanEvaluation result;
  const Eigen::Isometry2d T_map_truth = T_truth_map.inverse();
  const double trueCell_m2 = truth.resolution_m * truth.resolution_m;
  forEachFreeCell(truth, [&](const Eigen::Vector2d& p_truth_m) {
    const unsigned char told = valueAt(found, T_map_truth * p_truth_m);
    double& area_m2 = told == FloorPlan::kFree       ? result.free_m2
                      : told == FloorPlan::kOccupied ? result.occupied_m2
                                                     : result.unknown_m2;
    area_m2 += trueCell_m2;
  });
  const double foundCell_m2 = found.resolution_m * found.resolution_m;
  forEachFreeCell(found, [&](const Eigen::Vector2d& p_map_m) {
    if (valueAt(truth, T_truth_map * p_map_m) != FloorPlan::kFree) result.wronglyFree_m2 += foundCell_m2;
  });
  return result;
}

}  // namespace wardslam::evaluation
