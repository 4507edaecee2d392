#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <utility>
#include <vector>

#include "wardslam/graph/graph_options.h"
#include "wardslam/graph/keyframe_graph.h"
#include "wardslam/odometry/depth_view.h"
#include "wardslam/odometry/matcher.h"
#include "wardslam/odometry/pose_solver.h"

namespace wardslam::graph {

/// A place seen again: geometry says where the newer keyframe stood when seen from the older one.
struct Loop {
  KeyframeId older = 0;
  KeyframeId newer = 0;
  Eigen::Isometry3d T_older_newer = Eigen::Isometry3d::Identity();
  int inliers = 0;
  std::vector<std::pair<PointId, PointId>> samePoints;  ///< Seen by the newer; what it is at the older place.
  std::vector<KeyframeId> place;                        ///< Keyframes around, the older among them.
  double spread = 0.0;                  ///< Part of the newer one's image (of 4 x 4) in which it shows the place.
  odometry::DepthAgreement depth = {};  ///< What each says of the surfaces the other saw.
};

/// Decides whether a keyframe that looks like an old place is there: points of the place must be found where one pose
/// says they are, by reprojection and depth, and the correction must be one that drift can explain.
class LoopVerification {
 public:
  LoopVerification(const LoopVerificationOptions& options, const odometry::MatcherOptions& matcher,
                   const odometry::PoseSolverOptions& solver)
      : options_(options), matcher_(matcher), solver_(solver) {}

  /// The keyframe and those that see most of the same: one place.
  [[nodiscard]] std::vector<KeyframeId> placeAround(const KeyframeGraph& graph, KeyframeId keyframe) const;

  /// The loop's older keyframe is the one of the place most of whose points are found. `closed`: loops that tie
  /// keyframes together already.
  [[nodiscard]] std::optional<Loop> verify(const KeyframeGraph& graph, KeyframeId newer,
                                           const std::vector<KeyframeId>& place,
                                           const std::vector<Loop>& closed = {}) const;

  /// By looks and depth alone, however far apart the two are said to be.
  [[nodiscard]] std::optional<Loop> look(const KeyframeGraph& graph, KeyframeId newer,
                                         const std::vector<KeyframeId>& place) const;

  /// Whether the camera can be where the loop says it is: by drift since, and between pieces by time.
  [[nodiscard]] bool isPlausible(const KeyframeGraph& graph, const Loop& loop, const std::vector<Loop>& closed) const;

  /// Whether a loop within one piece asks for no more than what is not settled can have drifted by, so that what is
  /// settled may stay where it is.
  [[nodiscard]] bool leavesTheSettled(const KeyframeGraph& graph, const Loop& loop,
                                      const std::vector<Loop>& closed) const;

 private:
  LoopVerificationOptions options_;
  odometry::Matcher matcher_;
  odometry::PoseSolver solver_;
};

}  // namespace wardslam::graph
