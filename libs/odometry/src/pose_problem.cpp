#include "pose_problem.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "wardslam/core/rigid_transform.h"
#include "wardslam/core/rotation_vector.h"
#include "wardslam/odometry/observation_error.h"

namespace wardslam::odometry {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr double kNearest_m = 0.01;
/// 95 % of motions that are as sure as said have a smaller squared error (chi-square, 6 degrees of freedom).
constexpr double kChiSquareOfPrior = 12.592;
constexpr double kStill = 1e-7;    // m, and rad
constexpr double kDamping = 1e-9;  // of the diagonal: keeps still what nothing is said of

/// How much a squared error counts where large ones are bent (Huber): as much as all up to the limit, then less.
double huberWeight(double squared, double limitSquared) {
  return squared <= limitSquared ? 1.0 : std::sqrt(limitSquared / squared);
}

/// What a small turn adds to a rotation vector: log(R(v) R(d)) = v + inverse(J) d.
Eigen::Matrix3d rightJacobian(const Eigen::Vector3d& rotation_rad) {
  const double angle_rad = rotation_rad.norm();
  const Eigen::Matrix3d cross = core::crossProductWith(rotation_rad);
  if (angle_rad < 1e-6) return Eigen::Matrix3d::Identity() - 0.5 * cross;
  const double square = angle_rad * angle_rad;
  return Eigen::Matrix3d::Identity() - (1.0 - std::cos(angle_rad)) / square * cross +
         (angle_rad - std::sin(angle_rad)) / (square * angle_rad) * cross * cross;
}

}  // namespace

/// Normal equations of a small motion of the map in the camera frame: translation (m), rotation vector (rad).
struct PoseProblem::NormalEquations {
  Matrix6 H = Matrix6::Zero();
  Vector6 gradient = Vector6::Zero();

  template <class Jacobian, class Error>
  void add(const Jacobian& J, const Error& error, double weight) {
    H.noalias() += weight * J.transpose() * J;
    gradient.noalias() += weight * J.transpose() * error;
  }

  [[nodiscard]] Vector6 step() const {
    Matrix6 damped = H;
    damped.diagonal() *= 1.0 + kDamping;
    damped.diagonal().array() += kDamping;
    return -damped.ldlt().solve(gradient);
  }
};

PoseProblem::PoseProblem(const std::vector<PointObservation>& observations, const core::CameraModel& camera,
                         const PoseSolverOptions& options, const PosePrior* prior)
    : maxIterations_(options.max_iterations) {
  sightings_.reserve(observations.size());
  for (const auto& [p_map_m, keypoint] : observations) {
    const double sigma_px = options.pixel_sigma_px * static_cast<double>(keypoint.scale);
    const Eigen::Vector2d focal_px(camera.fx_px, camera.fy_px);
    const Eigen::Vector2d fromCentre_px(static_cast<double>(keypoint.undistorted_px.x) - camera.cx_px,
                                        static_cast<double>(keypoint.undistorted_px.y) - camera.cy_px);
    const double perMetre =
        keypoint.hasDepth() ? 1.0 / (options.depth_sigma_scale * core::depthSigma_m(keypoint, camera.depthNoise)) : 0.0;
    sightings_.push_back({p_map_m, fromCentre_px.cwiseQuotient(focal_px), static_cast<double>(keypoint.depth_m),
                          focal_px / sigma_px, perMetre, chiSquareOf(keypoint),
                          static_cast<double>(keypoint.staticProbability)});
  }
  if (prior != nullptr) {
    prior_ = Prior{prior->T_cam_map, Eigen::LLT<PoseCovariance>(prior->covariance.inverse()).matrixU()};
  }
}

/// Gauss and Newton, with weights worked out anew in every round.
Eigen::Isometry3d PoseProblem::minimise(const Eigen::Isometry3d& T_cam_map, const std::vector<bool>& use,
                                        bool robust) const {
  if (std::count(use.begin(), use.end(), true) < 3) return T_cam_map;
  Eigen::Isometry3d T = T_cam_map;
  for (int round = 0; round < maxIterations_; ++round) {
    NormalEquations equations;
    for (std::size_t i = 0; i < sightings_.size(); ++i) {
      if (use[i]) addSighting(sightings_[i], T * sightings_[i].p_map_m, robust, equations);
    }
    if (prior_) addPrior(T, equations);
    const Vector6 step = equations.step();
    if (!step.allFinite()) return T_cam_map;
    T = core::rigid(core::motionBy(step.head<3>(), step.tail<3>()) * T);
    if (step.cwiseAbs().maxCoeff() < kStill) break;
  }
  return T;
}

void PoseProblem::addSighting(const Sighting& sighting, const Eigen::Vector3d& p_cam_m, bool robust,
                              NormalEquations& equations) {
  const auto error = errorOf(sighting, p_cam_m);
  if (!error) return;
  const double z_m = p_cam_m.z();
  const Eigen::Vector2d perMetre = sighting.perRay / z_m;
  Eigen::Matrix3d ofPoint;
  ofPoint << perMetre.x(), 0.0, -perMetre.x() * p_cam_m.x() / z_m,  //
      0.0, perMetre.y(), -perMetre.y() * p_cam_m.y() / z_m,         //
      0.0, 0.0, sighting.perMetre;
  Eigen::Matrix<double, 3, 6> J;
  J << ofPoint, -ofPoint * core::crossProductWith(p_cam_m);
  const double bent = robust ? huberWeight(error->squaredNorm(), sighting.chiSquare) : 1.0;
  equations.add(J, *error, sighting.weight * bent);
}

/// Where the camera is in the frame of the camera where it ought to be.
void PoseProblem::addPrior(const Eigen::Isometry3d& T_cam_map, NormalEquations& equations) const {
  const Eigen::Isometry3d T_prior_cam = core::rigid(prior_->T_cam_map * T_cam_map.inverse());
  const Eigen::Vector3d rotation_rad = core::rotationVectorOf(T_prior_cam.linear());
  Vector6 error;
  error << T_prior_cam.translation(), rotation_rad;
  Matrix6 J = Matrix6::Zero();
  J.topLeftCorner<3, 3>() = -T_prior_cam.linear();
  J.bottomRightCorner<3, 3>() = -rightJacobian(rotation_rad).inverse();
  error = prior_->squareRootInformation * error;
  J = prior_->squareRootInformation * J;
  equations.add(J, error, huberWeight(error.squaredNorm(), kChiSquareOfPrior));
}

/// The camera's own motion is the map's the other way round: the products are the same.
PoseCovariance PoseProblem::information(const Eigen::Isometry3d& T_cam_map) const {
  NormalEquations equations;
  for (const Sighting& sighting : sightings_) {
    addSighting(sighting, T_cam_map * sighting.p_map_m, /*robust=*/false, equations);
  }
  return equations.H;
}

std::vector<bool> PoseProblem::fitting(const Eigen::Isometry3d& T_cam_map) const {
  std::vector<bool> fits;
  fits.reserve(sightings_.size());
  for (const Sighting& sighting : sightings_) {
    const auto error = errorOf(sighting, T_cam_map * sighting.p_map_m);
    fits.push_back(error && error->squaredNorm() < sighting.chiSquare);
  }
  return fits;
}

std::vector<bool> PoseProblem::inFront(const Eigen::Isometry3d& T_cam_map) const {
  std::vector<bool> areInFront;
  areInFront.reserve(sightings_.size());
  for (const Sighting& sighting : sightings_) {
    areInFront.push_back(errorOf(sighting, T_cam_map * sighting.p_map_m).has_value());
  }
  return areInFront;
}

std::optional<Eigen::Vector3d> PoseProblem::errorOf(const Sighting& sighting, const Eigen::Vector3d& p_cam_m) {
  if (!(p_cam_m.z() >= kNearest_m)) return std::nullopt;
  const Eigen::Vector2d off = (p_cam_m.head<2>() / p_cam_m.z() - sighting.ray).cwiseProduct(sighting.perRay);
  return Eigen::Vector3d(off.x(), off.y(), (p_cam_m.z() - sighting.depth_m) * sighting.perMetre);
}

}  // namespace wardslam::odometry
