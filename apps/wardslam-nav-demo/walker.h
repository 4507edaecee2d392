#pragma once

#include <Eigen/Core>
#include <random>
#include <vector>

#include "true_world.h"
#include "wardslam/query/drivable_floor.h"

namespace wardslam::nav_demo {

/// How people are taken to behave.
struct WalkerHabits {
  double radius_m = 0.25;
  double slowest_mps = 0.7;  ///< Everybody has a pace of their own.
  double fastest_mps = 1.2;
  double acceleration_mps2 = 2.0;
  double shoulder_m = 0.1;  ///< What they would pass by nearer than this is in their way.
  double stopsAt_m = 0.35;  ///< They slow down for what is in their way and stand still when it is so near,
  double slowsAt_m = 1.2;
  double patience_s = 3.0;  ///< and after this long go somewhere else, around it.
};

/// Where people walk: on true floor, often to somewhere on the robot's way.
struct WalkingGround {
  const query::DrivableFloor* floor = nullptr;  ///< World frame, for a person's radius.
  std::vector<Eigen::Vector2d> attractions_m;   ///< Points of the robot's way.
};

/// Somebody who walks from place to place on the shortest way. World frame.
class Walker {
 public:
  Walker(const WalkingGround& ground, const WalkerHabits& habits, const Eigen::Vector2d& start_m, std::uint32_t seed);

  /// `others`: whom and what they see, themselves left out.
  void step(double dt_s, const std::vector<Disc>& others);

  [[nodiscard]] Disc disc() const { return {p_m_, habits_.radius_m}; }

 private:
  void choosePlace(const query::DrivableFloor& floor);
  [[nodiscard]] query::DrivableFloor floorAround(const std::vector<Disc>& others) const;
  [[nodiscard]] bool isInTheWay(const Disc& other) const;
  [[nodiscard]] double wantedSpeed_mps(const std::vector<Disc>& others) const;

  const WalkingGround& ground_;
  WalkerHabits habits_;
  Eigen::Vector2d p_m_;
  std::mt19937 random_;
  double pace_mps_ = 1.0;
  double speed_mps_ = 0.0;
  double rests_s_ = 0.0;
  double waited_s_ = 0.0;
  bool wasAttracted_ = false;
  std::vector<Eigen::Vector2d> way_m_;  ///< Still to go, the next point last.
};

/// A free place on the ground, at least `clear_m` from `away_m`. Throws core::InputError when there is none.
[[nodiscard]] Eigen::Vector2d placeAwayFrom(const WalkingGround& ground, const Eigen::Vector2d& away_m, double clear_m,
                                            std::mt19937& random);

}  // namespace wardslam::nav_demo
