#include "wardslam/exchange/occupancy_grid.h"

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>

namespace wardslam::exchange {
namespace {

using mapping::FloorPlan;

float freeProbability(unsigned char cell) {
  constexpr float kUndecided = 0.5F;
  if (cell == FloorPlan::kFree) return 1.0F;
  return cell == FloorPlan::kOccupied ? 0.0F : kUndecided;
}

}  // namespace

mrpt::maps::COccupancyGridMap2D toOccupancyGrid(const FloorPlan& plan) {
  const auto resolution_m = static_cast<float>(plan.resolution_m);
  const Eigen::Vector2f min_m = plan.origin_m.cast<float>();
  const Eigen::Vector2f max_m =
      (plan.origin_m + plan.resolution_m * Eigen::Vector2d(plan.cells.cols, plan.cells.rows)).cast<float>();
  mrpt::maps::COccupancyGridMap2D grid;
  grid.setSize(min_m.x(), max_m.x(), min_m.y(), max_m.y(), resolution_m);
  const int columns = std::min(plan.cells.cols, static_cast<int>(grid.getSizeX()));
  const int rows = std::min(plan.cells.rows, static_cast<int>(grid.getSizeY()));
  // MRPT may have moved the corner to a multiple of the resolution: cells go where their centres lie.
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Eigen::Vector2d centre_m = plan.origin_m + plan.resolution_m * Eigen::Vector2d(column + 0.5, row + 0.5);
      grid.setCell(grid.x2idx(static_cast<float>(centre_m.x())), grid.y2idx(static_cast<float>(centre_m.y())),
                   freeProbability(plan.cells.at<unsigned char>(row, column)));
    }
  }
  return grid;
}

}  // namespace wardslam::exchange
