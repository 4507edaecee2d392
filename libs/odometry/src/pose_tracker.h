#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "local_map.h"
#include "wardslam/odometry/depth_view.h"
#include "wardslam/odometry/keypoint_grid.h"
#include "wardslam/odometry/matcher.h"
#include "wardslam/odometry/motion_prior.h"
#include "wardslam/odometry/odometry_options.h"
#include "wardslam/odometry/pose_solver.h"

namespace wardslam::odometry {

/// One image as tracking sees it.
struct TrackedImage {
  double stamp_s;
  const core::CameraModel& camera;
  const core::Features& recorded;  ///< As the camera saw them, row after row, ...
  core::Features features;         ///< ... and as if it had seen all at once: what tracking works with.
  const DepthImage& depth;
  std::uint64_t frame;
  std::optional<PosePrior> prior;  ///< Where others say that the camera is.
  KeypointGrid grid{features.keypoints, camera};
};

/// A pose and the matches it rests on.
struct Tracking {
  Eigen::Isometry3d T_cam_map = Eigen::Isometry3d::Identity();
  std::vector<Match> inliers;
  std::vector<PointId> visible;  ///< Points that should have been found.
  int matches = 0;
  bool isHeldByDepth = false;  ///< Few points or none: what was not found is not missing.
  bool isGuess = false;        ///< In some direction nothing was seen: it goes on as predicted.
};

/// Finds the camera's pose in one image, by what the local map says should be seen.
class PoseTracker {
 public:
  explicit PoseTracker(const OdometryOptions& options)
      : options_(options), matcher_(options.matcher), solver_(options.pose_solver) {}

  [[nodiscard]] bool isGood(const Tracking& tracking) const {
    return static_cast<int>(tracking.inliers.size()) >= options_.min_inliers;
  }

  /// From a pose predicted by motion and the points the last image showed, searching wider until enough are found.
  [[nodiscard]] Tracking trackByMotion(const TrackedImage& view, const LocalMap& map,
                                       const std::vector<PointId>& lastSeen,
                                       const Eigen::Isometry3d& T_cam_map_predicted) const;

  /// From a pose that is nearly right: looks for all points of the neighbourhood.
  [[nodiscard]] Tracking trackNeighbourhood(const TrackedImage& view, const LocalMap& map, const Tracking& rough) const;

  /// As both of these, one after the other; what the first finds where that is too little.
  [[nodiscard]] Tracking track(const TrackedImage& view, const LocalMap& map, const std::vector<PointId>& lastSeen,
                               const Eigen::Isometry3d& T_cam_map_predicted) const;

  /// From a pose that surfaces tell: looks for the neighbourhood of the points seen last, as far as the pose may be
  /// off.
  [[nodiscard]] Tracking trackBesideDepth(const TrackedImage& view, const LocalMap& map,
                                          const std::vector<PointId>& lastSeen,
                                          const Eigen::Isometry3d& T_cam_map_held) const;

  /// The pose again, by the same matches: their key points have moved a little (TrackedImage::features).
  [[nodiscard]] Tracking trackAgain(const TrackedImage& view, const LocalMap& map, const Tracking& tracking) const;

  /// From nothing: by looks, which most of what should be in sight, its depth and the lack of another place like it
  /// must bear out, for one place of a hospital looks like another. Else without inliers.
  [[nodiscard]] Tracking relocalise(const TrackedImage& view, const LocalMap& map) const;

  /// Whether most of what should be in sight was found, and depth does not contradict: what only resembles a place does
  /// not show that.
  [[nodiscard]] bool isBorneOut(const TrackedImage& view, const LocalMap& map, const Tracking& found) const;

  /// Of a pose found in this image.
  [[nodiscard]] PoseCovariance covariance(const TrackedImage& view, const LocalMap& map,
                                          const Tracking& tracking) const;

 private:
  [[nodiscard]] Tracking search(const TrackedImage& view, const LocalMap& map, const std::vector<PointId>& points,
                                const Eigen::Isometry3d& T_cam_map, double radius_px) const;
  [[nodiscard]] Tracking agreeing(const TrackedImage& view, const LocalMap& map,
                                  const std::vector<Match>& matches) const;
  [[nodiscard]] bool hasRival(const TrackedImage& view, const LocalMap& map, const std::vector<Match>& matches,
                              const Tracking& found) const;
  /// The matches whose surroundings are alike too (P6), as far as both are known.
  [[nodiscard]] std::vector<Match> alike(const TrackedImage& view, const LocalMap& map,
                                         std::vector<Match> matches) const;
  [[nodiscard]] Tracking estimate(const TrackedImage& view, const LocalMap& map, const std::vector<Match>& matches,
                                  const Eigen::Isometry3d& T_cam_map) const;
  [[nodiscard]] std::vector<PointObservation> observe(const TrackedImage& view, const LocalMap& map,
                                                      const std::vector<Match>& matches) const;

  const OdometryOptions& options_;
  Matcher matcher_;
  PoseSolver solver_;
};

}  // namespace wardslam::odometry
