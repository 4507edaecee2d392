#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "wardslam/mapping/floor_plan.h"

namespace wardslam::query {

/// Ways over the free floor, cell by cell, by Dijkstra's algorithm. A cell here is free when all of it is.
class FloorWays {
 public:
  using Cell = std::size_t;

  /// Cells are those of the plan, or several of them where those are narrower than `smallestCell_m`.
  explicit FloorWays(const mapping::FloorPlan& plan, double smallestCell_m = 0.1);

  [[nodiscard]] std::size_t cellCount() const { return free_.total(); }

  /// The free cells whose centre lies within `reach_m` of a box (horizontally).
  void forEachFreeCellNear(const Eigen::AlignedBox2d& box_m, double reach_m,
                           const std::function<void(Cell)>& take) const;

  /// The free cell nearest to a point, at most `reach_m` off.
  [[nodiscard]] std::optional<Cell> freeCellNear(const Eigen::Vector2d& p_map_m, double reach_m) const;

  /// Visits cells in order of their distance along the floor until `arrive` says true. Returns that distance.
  [[nodiscard]] std::optional<double> walk(Cell start, const std::function<bool(Cell)>& arrive) const;

  /// The corners of a short way between the middles of two free cells, both included: the shortest way from cell to
  /// cell, made straight where the floor between two of its cells is free. Nothing where no way leads.
  [[nodiscard]] std::optional<std::vector<Eigen::Vector2d>> wayBetween(Cell start, Cell goal) const;

 private:
  class Distances;
  [[nodiscard]] Eigen::Vector2d centre_m(int row, int column) const;
  [[nodiscard]] Eigen::Vector2d centre_m(Cell cell) const;
  [[nodiscard]] cv::Point pixelOf(Cell cell) const;
  [[nodiscard]] bool seesEachOther(Cell a, Cell b) const;
  [[nodiscard]] std::optional<int> spread(Cell start, const std::function<bool(Cell)>& arrive,
                                          Distances& distances) const;
  [[nodiscard]] std::vector<Cell> backFrom(Cell goal, const Distances& distances) const;

  cv::Mat free_;  ///< CV_8UC1, a border of cells that are not free around it.
  double cell_m_ = 0.0;
  Eigen::Vector2d origin_m_ = Eigen::Vector2d::Zero();  ///< Outer corner of cell (0, 0), border included.
};

}  // namespace wardslam::query
