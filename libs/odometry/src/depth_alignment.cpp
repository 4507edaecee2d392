#include "depth_alignment.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

#include "twist.h"
#include "wardslam/core/rotation_vector.h"

namespace wardslam::odometry {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr int kMaxRounds = 12;
constexpr int kMostSamples = 1000;  // points that are aligned, about
constexpr int kMinPairs = 100;
constexpr double kFirstLimit_m = 0.24;   // pairs farther apart are none: half of it with every round, ...
constexpr double kLastLimit_m = 0.03;    // ... down to this, ...
constexpr double kLimitPerMetre = 0.02;  // ... the more the farther away
constexpr double kSameSide = 0.7;        // cosine between the normals of a pair
constexpr double kRobustSigmas = 2.0;
constexpr double kSignalToNoise = 4.0;    // what noise alone could turn to a direction, times this, leaves it open
constexpr double kPointsPerOpinion = 10;  // neighbours are wrong together: quantisation, calibration, uneven walls
constexpr double kStill = 1e-4;           // m, and rad

struct SurfacePoint {
  Eigen::Vector3d p_m;
  Eigen::Vector3d normal;
};

struct Pair {
  Eigen::Vector3d p_now_m;     ///< In the frame of the camera now.
  Eigen::Vector3d normal_now;  ///< Of the surface, likewise.
  double off_m = 0.0;          ///< How far the point lies in front of the surface.
  double weight_per_m2 = 0.0;
  double normalVariance_rad2 = 0.0;
};

struct Pairs {
  std::vector<Pair> pairs;
  int compared = 0;  ///< Points that the image before could have shown.
};

double sigma_m(const Eigen::Vector3d& p_cam_m, const Eigen::Vector3d& normal, const core::DepthNoise& noise) {
  return noise.sigma_m(p_cam_m.z()) * std::abs(normal.dot(p_cam_m)) / p_cam_m.norm() + noise.least_m;
}

/// Of a pair `off_m` apart (Geman and McClure's loss): what fits counts, what does not is somebody who walks by. Early,
/// when nothing fits yet, `spread_m` is what may be off.
double weightOf(double off_m, double variance_m2, double spread_m) {
  const double scale_m = kRobustSigmas * std::sqrt(variance_m2) + spread_m;
  const double share = 1.0 / (1.0 + off_m * off_m / (scale_m * scale_m));
  return share * share / variance_m2;
}

/// As many as there are to have, of what may be a small part of the image.
std::vector<SurfacePoint> sample(const DepthSurface& surface) {
  int squares = 0;
  for (int row = 0; row < surface.rows(); ++row) {
    for (int column = 0; column < surface.columns(); ++column) squares += surface.point(column, row).z() > 0.0F ? 1 : 0;
  }
  const int step = std::max(1, static_cast<int>(std::lround(std::sqrt(static_cast<double>(squares) / kMostSamples))));
  std::vector<SurfacePoint> points;
  for (int row = 0; row < surface.rows(); row += step) {
    for (int column = 0; column < surface.columns(); column += step) {
      const Eigen::Vector3f& p_m = surface.point(column, row);
      if (p_m.z() <= 0.0F) continue;
      const Eigen::Vector3f normal = surface.normal(column, row);
      if (!normal.isZero()) points.push_back({p_m.cast<double>(), normal.cast<double>()});
    }
  }
  return points;
}

Pairs pairUp(const std::vector<SurfacePoint>& now, const core::DepthNoise& noiseNow, const DepthSurface& before,
             const Eigen::Isometry3d& T_before_now, double limit_m) {
  Pairs found;
  for (const SurfacePoint& point : now) {
    const Eigen::Vector3d p_before_m = T_before_now * point.p_m;
    const auto square = before.squareOf(p_before_m);
    if (!square) continue;
    const Eigen::Vector3d shown_m = before.point(square->x(), square->y()).cast<double>();
    if (shown_m.z() <= 0.0) continue;
    ++found.compared;
    if ((shown_m - p_before_m).norm() > limit_m + kLimitPerMetre * p_before_m.z()) continue;
    const Eigen::Vector3d normal = before.normal(square->x(), square->y()).cast<double>();
    const Eigen::Vector3d normal_now = T_before_now.linear().transpose() * normal;
    if (point.normal.dot(normal_now) < kSameSide) continue;
    const double a_m = sigma_m(point.p_m, normal_now, noiseNow);
    const double b_m = sigma_m(shown_m, normal, before.camera().depthNoise);
    const double off_m = normal.dot(p_before_m - shown_m);
    const double weight_per_m2 = weightOf(off_m, a_m * a_m + b_m * b_m, 0.5 * (limit_m - kLastLimit_m));
    const double turned_rad = before.normalSigma_rad(shown_m, normal);
    found.pairs.push_back({point.p_m, normal_now, off_m, weight_per_m2, turned_rad * turned_rad});
  }
  return found;
}

/// The normal equations of a small motion of the camera now: translation (m), rotation times the mean depth (rad m), so
/// that all six have one unit.
struct NormalEquations {
  PoseCovariance H = PoseCovariance::Zero();
  Vector6 gradient = Vector6::Zero();
  PoseCovariance noise = PoseCovariance::Zero();  ///< What H would be if noise alone had turned the normals.
  double depth_m = 0.0;

  explicit NormalEquations(const std::vector<Pair>& pairs) {
    for (const Pair& pair : pairs) depth_m += pair.p_now_m.z() / static_cast<double>(pairs.size());
    double weights = 0.0;
    Eigen::Vector3d middle_m = Eigen::Vector3d::Zero();
    Eigen::Matrix3d spread_m2 = Eigen::Matrix3d::Zero();
    for (const Pair& pair : pairs) {
      Vector6 J;
      J << pair.normal_now, pair.p_now_m.cross(pair.normal_now) / depth_m;
      H += pair.weight_per_m2 * J * J.transpose();
      gradient += pair.weight_per_m2 * pair.off_m * J;
      const double weight = pair.weight_per_m2 * pair.normalVariance_rad2;
      weights += weight;
      middle_m += weight * pair.p_now_m;
      spread_m2 += weight * pair.p_now_m * pair.p_now_m.transpose();
    }
    // Sum of transpose(M) * M, where M = (1, -cross product with the point) is how the point moves.
    const Eigen::Matrix3d cross = core::crossProductWith(middle_m) / depth_m;
    noise << weights * Eigen::Matrix3d::Identity(), -cross, cross,
        (spread_m2.trace() * Eigen::Matrix3d::Identity() - spread_m2) / (depth_m * depth_m);
  }
};

/// What the equations say, apart from what they leave open.
struct Step {
  Vector6 motion = Vector6::Zero();
  PoseCovariance information = PoseCovariance::Zero();
  int open = 0;
};

Step solve(const NormalEquations& equations) {
  const Eigen::SelfAdjointEigenSolver<PoseCovariance> eigen(equations.H);
  Step step;
  for (int i = 0; i < 6; ++i) {
    const double value = eigen.eigenvalues()[i];
    const Vector6 direction = eigen.eigenvectors().col(i);
    if (value < kSignalToNoise * direction.dot(equations.noise * direction)) {
      ++step.open;
      continue;
    }
    step.motion -= direction * direction.dot(equations.gradient) / value;
    step.information += value / kPointsPerOpinion * direction * direction.transpose();
  }
  return step;
}

}  // namespace

DepthAlignment alignDepth(const DepthSurface& now, const DepthSurface& before,
                          const Eigen::Isometry3d& T_before_now_guess, AlignmentStart start) {
  const std::vector<SurfacePoint> points = sample(now);
  DepthAlignment alignment;
  alignment.T_before_now = T_before_now_guess;
  double limit_m = start == AlignmentStart::IsNear ? kLastLimit_m : kFirstLimit_m;
  for (int round = 0; round < kMaxRounds; ++round, limit_m = std::max(kLastLimit_m, 0.5 * limit_m)) {
    const Pairs found = pairUp(points, now.camera().depthNoise, before, alignment.T_before_now, limit_m);
    if (found.pairs.size() < kMinPairs) return {T_before_now_guess, PoseCovariance::Zero(), 6, 0.0, 0.0};
    const NormalEquations equations(found.pairs);
    const Step step = solve(equations);
    Vector6 units;
    units << 1.0, 1.0, 1.0, equations.depth_m, equations.depth_m, equations.depth_m;
    const Vector6 motion = step.motion.cwiseQuotient(units);
    alignment.T_before_now = alignment.T_before_now * after({motion.head<3>(), motion.tail<3>()}, 1.0);
    alignment.information = units.asDiagonal() * step.information * units.asDiagonal();
    alignment.open = step.open;
    alignment.overlap = static_cast<double>(found.pairs.size()) / static_cast<double>(points.size());
    alignment.agreement = static_cast<double>(found.pairs.size()) / found.compared;
    if (motion.cwiseAbs().maxCoeff() < kStill && limit_m == kLastLimit_m) break;
  }
  return alignment;
}

}  // namespace wardslam::odometry
