#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "wardslam/mapping/floor_plan.h"
#include "wardslam/mapping/map_object.h"
#include "wardslam/mapping/zone.h"

namespace wardslam::query {

/// What a robot must keep to.
struct DrivingRules {
  double radius_m = 0.25;                ///< Of a circle around the robot, margin included.
  std::vector<mapping::Zone> forbidden;  ///< No part of the circle may enter these.
  bool unknownIsFree = false;
};

/// The plan with every cell occupied that one of the zones touches.
[[nodiscard]] mapping::FloorPlan closeZones(const mapping::FloorPlan& plan, const std::vector<mapping::Zone>& zones);

/// A place to stop and where to look.
struct Spot {
  Eigen::Vector2d p_map_m = Eigen::Vector2d::Zero();
  double yaw_rad = 0.0;  ///< Map frame, 0 = along x.
};

/// Where the middle of a round robot may be.
class DrivableFloor {
 public:
  DrivableFloor(const mapping::FloorPlan& plan, const DrivingRules& rules);

  /// Free where the robot's middle may be, occupied elsewhere: for planners that take the robot for a point.
  [[nodiscard]] const mapping::FloorPlan& plan() const { return plan_; }

  /// The nearest place for the robot's middle, at most `reach_m` off; the point itself where it may be there.
  [[nodiscard]] std::optional<Eigen::Vector2d> nearestFree(const Eigen::Vector2d& p_map_m, double reach_m) const;

  /// A place beside an object, facing its nearest edge, at most `reach_m` from the robot's circle to the object's
  /// footprint. Of places about as near (0.1 m) the one with the most room. With `from`: only what a way leads to from
  /// there. Nothing where there is no such place.
  [[nodiscard]] std::optional<Spot> spotBeside(const mapping::MapObject& object, double reach_m,
                                               const std::optional<Eigen::Vector2d>& from_map_m = {}) const;

 private:
  [[nodiscard]] cv::Point cellAt(const Eigen::Vector2d& p_map_m) const;
  [[nodiscard]] Eigen::Vector2d centre_m(const cv::Point& cell) const;

  mapping::FloorPlan plan_;
  double radius_m_ = 0.0;
  cv::Mat room_m_;  ///< CV_32FC1: from the middle of a cell to the nearest that is not open.
  cv::Mat part_;    ///< CV_32SC1: cells with one number hang together; 0 = not free.
};

}  // namespace wardslam::query
