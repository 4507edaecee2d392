#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <map>

#include "wardslam/odometry/map_update.h"
#include "wardslam/odometry/motion_prior.h"

namespace wardslam::odometry {

/// How far the map around the camera may have drifted since its piece began. Every keyframe is placed by the map of
/// those before and errs on its own, so errors add up from one to the next; who sees a place again is as sure as he was
/// there.
class MapDrift {
 public:
  /// Keyframes up to this one are of earlier runs, whose map is taken for exact.
  explicit MapDrift(KeyframeId lastOfEarlierRuns) : lastOfEarlierRuns_(lastOfEarlierRuns) {}

  /// With the first keyframe of a piece.
  void begin(KeyframeId first);

  /// `ofPose`: the covariance of the keyframe's pose within the local map.
  void add(KeyframeId id, const Eigen::Isometry3d& T_before_this, const PoseCovariance& ofPose);

  /// `isMoved`: the newer keyframe's piece came into the frame of the older one's; else what is surer counts.
  void seeAgain(const PlaceSeenAgain& place, bool isMoved);

  /// Of the newest keyframe, seen from a camera: the covariance of a small motion in its frame, as MotionPrior's.
  [[nodiscard]] PoseCovariance at(const Eigen::Isometry3d& T_keyframe_cam) const;

 private:
  struct Entry {
    Eigen::Isometry3d T_before_this = Eigen::Isometry3d::Identity();
    PoseCovariance added = PoseCovariance::Zero();  ///< By this keyframe.
    PoseCovariance drift = PoseCovariance::Zero();
  };

  void keep(KeyframeId id, const Entry& entry);

  KeyframeId lastOfEarlierRuns_;
  std::map<KeyframeId, Entry> keyframes_;  ///< The newest ones, of all pieces.
};

}  // namespace wardslam::odometry
