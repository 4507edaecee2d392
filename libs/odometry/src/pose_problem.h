#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "wardslam/odometry/pose_solver.h"

namespace wardslam::odometry {

/// What observations and a prior say of one camera pose, as a least squares problem that knows its derivatives. Points
/// are taken for exact.
class PoseProblem {
 public:
  /// `prior` (may be null) counts in every minimise(), bent for large errors (Huber).
  PoseProblem(const std::vector<PointObservation>& observations, const core::CameraModel& camera,
              const PoseSolverOptions& options, const PosePrior* prior);

  /// From this pose, over the observations that `use` selects; `robust` bends the cost of large errors (Huber). The
  /// same pose where fewer than three are selected.
  [[nodiscard]] Eigen::Isometry3d minimise(const Eigen::Isometry3d& T_cam_map, const std::vector<bool>& use,
                                           bool robust) const;

  /// Of the observations at this pose, all of them, large errors not bent; the prior left out.
  [[nodiscard]] PoseCovariance information(const Eigen::Isometry3d& T_cam_map) const;

  /// Per observation, whether its error at this pose is one of the smaller 95 % that correct ones have.
  [[nodiscard]] std::vector<bool> fitting(const Eigen::Isometry3d& T_cam_map) const;
  [[nodiscard]] std::vector<bool> inFront(const Eigen::Isometry3d& T_cam_map) const;

 private:
  struct NormalEquations;

  /// An observation, and one over its standard deviations.
  struct Sighting {
    Eigen::Vector3d p_map_m;
    Eigen::Vector2d ray;  ///< At a depth of one metre.
    double depth_m;
    Eigen::Vector2d perRay;  ///< Focal length over the standard deviation of a pixel.
    double perMetre;         ///< 0: no depth was measured.
    double chiSquare;
    double weight;  ///< How likely the point is static.
  };
  struct Prior {
    Eigen::Isometry3d T_cam_map;
    PoseCovariance squareRootInformation;
  };

  /// In units of standard deviations; null behind the camera.
  [[nodiscard]] static std::optional<Eigen::Vector3d> errorOf(const Sighting& sighting, const Eigen::Vector3d& p_cam_m);
  static void addSighting(const Sighting& sighting, const Eigen::Vector3d& p_cam_m, bool robust,
                          NormalEquations& equations);
  void addPrior(const Eigen::Isometry3d& T_cam_map, NormalEquations& equations) const;

  std::vector<Sighting> sightings_;
  std::optional<Prior> prior_;
  int maxIterations_;
};

}  // namespace wardslam::odometry
