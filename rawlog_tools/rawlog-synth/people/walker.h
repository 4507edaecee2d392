#pragma once

#include <Eigen/Core>
#include <vector>

namespace wardslam::synth {

/// Where somebody is when. Two waypoints at one place: standing there.
struct Waypoint {
  double t_s;
  Eigen::Vector2d p_m;
};

struct Gait {
  Eigen::Vector2d p_m = Eigen::Vector2d::Zero();
  double heading_rad = 0.0;  ///< Continuous, not wrapped.
  double speed_mps = 0.0;
  double walked_m = 0.0;  ///< Since the start; the legs swing with it.
  bool moving = false;    ///< Walking or turning on the spot.
};

/// Walks along waypoints without overshoot, starting and stopping softly. After the last waypoint the part of the
/// route from `loopFrom_s` on is repeated for ever; it must end where it began.
class Walker {
 public:
  /// Throws std::invalid_argument when times do not increase or the loop does not close.
  Walker(const std::vector<Waypoint>& route, double loopFrom_s);

  [[nodiscard]] Gait at(double t_s) const;

 private:
  std::vector<Gait> table_;  ///< Every kStep_s, once through the route and once more through the loop.
  double end_s_;
  double loop_s_;
};

}  // namespace wardslam::synth
