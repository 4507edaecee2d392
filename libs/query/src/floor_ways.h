#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <opencv2/core.hpp>
#include <optional>

#include "wardslam/mapping/floor_plan.h"

namespace wardslam::query {

/// Ways over the free floor, cell by cell. A cell here is at least 0.1 m wide and free when all of it is.
class FloorWays {
 public:
  using Cell = std::size_t;

  explicit FloorWays(const mapping::FloorPlan& plan);

  [[nodiscard]] std::size_t cellCount() const { return free_.total(); }

  /// The free cells whose centre lies within `reach_m` of a box (horizontally).
  void forEachFreeCellNear(const Eigen::AlignedBox2d& box_m, double reach_m,
                           const std::function<void(Cell)>& take) const;

  /// The free cell nearest to a point, at most `reach_m` off.
  [[nodiscard]] std::optional<Cell> freeCellNear(const Eigen::Vector2d& p_map_m, double reach_m) const;

  /// Visits cells in order of their distance along the floor until `arrive` says true. Returns that distance.
  [[nodiscard]] std::optional<double> walk(Cell start, const std::function<bool(Cell)>& arrive) const;

 private:
  [[nodiscard]] Eigen::Vector2d centre_m(int row, int column) const;

  cv::Mat free_;  ///< CV_8UC1, a border of cells that are not free around it.
  double cell_m_ = 0.0;
  Eigen::Vector2d origin_m_ = Eigen::Vector2d::Zero();  ///< Outer corner of cell (0, 0), border included.
};

}  // namespace wardslam::query
