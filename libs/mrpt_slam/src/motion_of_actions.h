#pragma once

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservationOdometry.h>

#include <optional>

#include "wardslam/odometry/motion_prior.h"

namespace wardslam::mrpt_slam {

/// How the robot moved, by what wheels say: the motion in three dimensions where there is one, else the best one in
/// two. Covariances are those of the action, about the base as it stands then. What wheels cannot know, how the floor
/// lifts and tilts the robot, gets the standard deviations 5 mm and 0.01 rad; no number is surer than 0.1 mm or 0.0001
/// rad. Nothing: there is no motion among the actions. Throws core::InputError when the numbers are no motion.
[[nodiscard]] std::optional<odometry::MotionPrior> motionOf(const mrpt::obs::CActionCollection& actions);

/// Motions by the readings of an odometer, which come at times of their own: as fast as between the last two, with the
/// covariance of MRPT's motion model for such and its default parameters.
class OdometerMotion {
 public:
  void add(const mrpt::obs::CObservationOdometry& reading);

  /// Between two images. Nothing: there are not two readings yet, or the last is older than `to_s` by more than the
  /// time between both.
  [[nodiscard]] std::optional<odometry::MotionPrior> between(double from_s, double to_s) const;

 private:
  struct Reading {
    double stamp_s = 0.0;
    mrpt::poses::CPose2D pose;
  };
  std::optional<Reading> last_;
  std::optional<Reading> before_;
};

}  // namespace wardslam::mrpt_slam
