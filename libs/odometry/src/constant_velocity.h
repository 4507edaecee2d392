#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "twist.h"
#include "wardslam/odometry/motion_prior.h"

namespace wardslam::odometry {

/// How the camera goes on when nobody says: as fast as it last was, per second, whatever the times between images.
class ConstantVelocity {
 public:
  /// It moved by `T_now_before` within `since_s`. No time passed, or time went back: nothing is known. `isSure`: by
  /// what was seen; else that was a guess in part, and what follows from it is one on top.
  void observe(const Eigen::Isometry3d& T_now_before, double since_s, bool isSure);
  void forget() {
    twist_.reset();
    unsureFor_s_ = 0.0;
  }

  /// Its motion in the next `ahead_s` (at most half a second of it: nobody goes on for longer as he went), and how sure
  /// that is: people and robots speed up and turn as they like, so errors grow with the square of the time since the
  /// velocity was last seen. Where none is known, it may go as fast as they do.
  [[nodiscard]] MotionPrior predict(double ahead_s) const;

 private:
  std::optional<Twist> twist_;  ///< Nothing: it is taken to stand.
  double unsureFor_s_ = 0.0;
};

}  // namespace wardslam::odometry
