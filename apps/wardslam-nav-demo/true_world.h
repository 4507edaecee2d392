#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <vector>

#include "wardslam/mapping/floor_plan.h"

namespace wardslam::nav_demo {

/// Somebody or something round on the floor, in the world frame.
struct Disc {
  Eigen::Vector2d p_m = Eigen::Vector2d::Zero();
  double radius_m = 0.0;
};

/// What truly stands on the floor, whatever the map says. World frame.
class TrueWorld {
 public:
  explicit TrueWorld(mapping::FloorPlan floor);

  [[nodiscard]] const mapping::FloorPlan& floor() const { return floor_; }

  /// Distance from the point to the nearest thing, to about half a cell; 0 within things and outside of the plan.
  [[nodiscard]] double roomAt_m(const Eigen::Vector2d& p_m) const;

  /// How far one sees along a direction (unit vector): to the nearest thing or disc, at most `range_m`.
  [[nodiscard]] double sightFrom_m(const Eigen::Vector2d& p_m, const Eigen::Vector2d& direction, double range_m,
                                   const std::vector<Disc>& discs) const;

 private:
  mapping::FloorPlan floor_;
  cv::Mat room_m_;  ///< CV_32FC1, by cell.
};

}  // namespace wardslam::nav_demo
