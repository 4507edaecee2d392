#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "wardslam/core/camera_model.h"
#include "wardslam/core/keypoint.h"
#include "wardslam/odometry/depth_view.h"
#include "wardslam/odometry/keyframe.h"
#include "wardslam/odometry/map_update.h"
#include "wardslam/odometry/motion_prior.h"
#include "wardslam/odometry/odometry_options.h"
#include "wardslam/odometry/pieces.h"

namespace wardslam::odometry {

enum class State { Initialising, Ok, Lost };

[[nodiscard]] std::string toString(State state);

/// What tracking made of one image.
struct OdometryResult {
  State state = State::Initialising;
  /// Meaningful when state is Ok. When it is Lost: where motion priors since then lead; without, for a second, where
  /// the camera is if it goes on as it went, and then where it was last.
  Eigen::Isometry3d T_map_cam = Eigen::Isometry3d::Identity();
  /// How sure that is (MotionPrior::covariance, in the camera frame) within the local map, taken for exact. Nothing
  /// where nobody knows: lost for a while without motion priors.
  std::optional<PoseCovariance> covariance;
  /// How far the map around the camera may have drifted since its piece began, likewise. Both together,
  /// covarianceInPiece(), tell how sure T_map_cam is as a place in the frame of the whole piece: the drift is what
  /// matters to who compares places far apart, and is nothing to who stays where he is.
  PoseCovariance drift = PoseCovariance::Zero();
  KeyframeId referenceKeyframe = 0;  ///< The newest keyframe; corrections of its pose move this one along.
  Eigen::Isometry3d T_keyframe_cam = Eigen::Isometry3d::Identity();
  int matches = 0;                           ///< Map points found in the image.
  int inliers = 0;                           ///< Of these, the ones the pose rests on.
  bool isHeldByDepth = false;                ///< Too few points were found: surfaces alone say where the camera is.
  std::shared_ptr<const Keyframe> keyframe;  ///< Set when new points were added to the local map.
  /// How long the camera takes to read an image from its first row to its last, as far as found out by now.
  double readout_s = 0.0;
  /// Which piece of the map the pose is in, as far as known by now. Poses of two pieces have nothing in common.
  std::uint32_t piece = 0;
  /// Whether that piece is the map (Pieces). If not, tracking was lost and begun anew where it took itself to be: the
  /// pose is right only relative to others of the same piece, until a place of the map is recognised.
  bool isInMap = true;

  [[nodiscard]] bool hasPose() const { return state == State::Ok; }
  [[nodiscard]] std::optional<PoseCovariance> covarianceInPiece() const {
    return covariance ? std::optional<PoseCovariance>(*covariance + drift) : std::nullopt;
  }
  [[nodiscard]] std::optional<Eigen::Isometry3d> pose() const {
    return hasPose() ? std::optional(T_map_cam) : std::nullopt;
  }
};

/// Where the numbering of an earlier run ended; the next one goes on behind it.
struct Continuation {
  KeyframeId lastKeyframe = 0;
  PointId lastPoint = 0;
  std::uint32_t submap = 0;          ///< The first that is free.
  std::optional<std::uint32_t> map;  ///< The piece that is the map, and stays it.
};

/// Where the camera stands in the map frame when a piece begins, given where it is believed to.
using Placement = std::function<Eigen::Isometry3d(const Eigen::Isometry3d& T_map_cam)>;

/// RGB-D visual odometry on ORB key points against a local map of points. It sees key points that are static and
/// nothing else: no class names, no networks.
///
/// Plain and single-threaded; the same input gives the same output.
class Odometry {
 public:
  explicit Odometry(const OdometryOptions& options, const Continuation& earlier = {});
  ~Odometry();
  Odometry(Odometry&&) noexcept;
  Odometry& operator=(Odometry&&) noexcept;

  /// False until an image came that tracking could start from.
  [[nodiscard]] bool hasStarted() const;

  /// Where the camera is in the map frame when tracking starts: the identity unless told. Without effect later.
  void startFrom(const Eigen::Isometry3d& T_map_cam);

  /// Finds the camera's pose from the static features of the next image. Its depth tells places that look the same
  /// apart, and goes along with keyframes. `motion`: of the camera since the image before, in place of a constant
  /// velocity; it also counts as a measurement of the pose, and leads on where the image shows too little. `placeAnew`
  /// is asked when tracking was lost and a piece begins with this image; without it, where the camera was last.
  OdometryResult track(double stamp_s, const core::CameraModel& camera, const core::Features& staticFeatures,
                       const DepthImage& depth = {}, const std::optional<MotionPrior>& motion = {},
                       const Placement& placeAnew = {});

  /// Takes over better positions of points and keyframes. After a loop, what the mapper did not know yet, the camera
  /// above all, moves as the newest keyframe does that it knew; an update of a submap that tracking has left changes
  /// nothing. Returns how the camera was moved within the map frame.
  Eigen::Isometry3d apply(const std::shared_ptr<const MapUpdate>& update);
  Eigen::Isometry3d apply(const MapUpdate& update) { return apply(std::make_shared<const MapUpdate>(update)); }

 private:
  class Tracker;
  std::unique_ptr<Tracker> tracker_;
};

}  // namespace wardslam::odometry
