#pragma once

#include <map>
#include <optional>
#include <vector>

#include "wardslam/core/trajectory.h"
#include "wardslam/odometry/map_update.h"
#include "wardslam/odometry/trajectory_smoother.h"
#include "wardslam/pipeline/frame_observer.h"

namespace wardslam::pipeline {

/// Remembers every frame relative to its keyframe, so that later corrections of the map correct it too. This is the one
/// thing in a run that grows with time: by some 300 bytes a frame.
class TrajectoryRecorder : public FrameObserver {
 public:
  explicit TrajectoryRecorder(const odometry::SmoothingOptions& options = {}) : options_(options) {}

  void onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) override;

  /// Frames of keyframes that were removed hang on the heirs from now on.
  void onUpdate(const odometry::MapUpdate& update) override;

  /// One pose per frame tracked by one of these keyframes, by where they are now.
  [[nodiscard]] core::Trajectory corrected(
      const std::map<odometry::KeyframeId, Eigen::Isometry3d>& T_map_keyframe) const;

  /// The same on one way (odometry::smoothed), and for frames not tracked in between. The way leads through the
  /// keyframes themselves. Takes a tenth of a millisecond a frame: for a run that has ended.
  [[nodiscard]] core::Trajectory onOneWay(
      const std::map<odometry::KeyframeId, Eigen::Isometry3d>& T_map_keyframe) const;

 private:
  /// With as many digits of the covariance as anybody needs.
  struct RelativePose {
    double stamp_s = 0.0;
    Eigen::Isometry3d T_keyframe_cam = Eigen::Isometry3d::Identity();
    std::optional<Eigen::Matrix<float, 6, 6>> covariance;
    bool isSeen = true;
    bool isKeyframe = false;  ///< Itself: many images say where it is, and the way leads through it.
  };

  [[nodiscard]] std::vector<odometry::EstimatedPose> placed(
      const std::map<odometry::KeyframeId, Eigen::Isometry3d>& T_map_keyframe) const;

  odometry::SmoothingOptions options_;
  std::map<odometry::KeyframeId, std::vector<RelativePose>> framesOf_;
};

}  // namespace wardslam::pipeline
