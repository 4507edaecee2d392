#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <vector>

#include "true_world.h"
#include "wardslam/mapping/zone.h"

namespace wardslam::nav_demo {

/// What came of a run, measured in the true world between hulls.
struct Verdict {
  double nearestThing_m = std::numeric_limits<double>::infinity();
  double nearestPerson_m = std::numeric_limits<double>::infinity();
  int contactsWithThings = 0;
  int contactsWithPeople = 0;
  int encounters = 0;    ///< Times somebody came within a metre.
  int zonesEntered = 0;  ///< Times any part of the robot got into a forbidden zone.
  double way_m = 0.0;

  [[nodiscard]] bool isClean() const { return contactsWithThings == 0 && contactsWithPeople == 0 && zonesEntered == 0; }
};

/// Watches a round robot in the true world.
class Judge {
 public:
  /// Zones in the map frame.
  Judge(const TrueWorld& world, std::vector<mapping::Zone> forbidden, const Eigen::Isometry2d& T_world_map,
        double radius_m);

  void look(const Eigen::Vector2d& robot_world_m, const std::vector<Disc>& people);
  [[nodiscard]] const Verdict& verdict() const { return verdict_; }

 private:
  const TrueWorld& world_;
  std::vector<mapping::Zone> forbidden_;
  Eigen::Isometry2d T_map_world_;
  double radius_m_;
  Verdict verdict_;
  bool touchesThing_ = false;
  bool isInZone_ = false;
  std::vector<bool> touchesPerson_;
  std::vector<bool> isNearPerson_;
  bool hasLast_ = false;
  Eigen::Vector2d last_m_ = Eigen::Vector2d::Zero();
};

}  // namespace wardslam::nav_demo
