#include "readout_estimator.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "wardslam/core/rotation_vector.h"

namespace wardslam::odometry {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr std::size_t kImages = 4;  // two that are compared, and their neighbours, which tell how fast the camera was
constexpr std::size_t kMinPoints = 30;
constexpr double kLeastTurn_radps = 0.3;  // slower, what is wrong with depth and lens says more than the readout
constexpr double kLongest_s = 0.05;
constexpr double kNearest_m = 0.1;
constexpr double kPixelSigma_px = 1.5;
constexpr double kTrimSigmas = 3.0;
constexpr double kSureSigmas = 2.0;        // nearer to 0 it is 0: a global shutter is left alone
constexpr double kPointsPerOpinion = 5.0;  // neighbours err together

/// What one point says: error = ofPose * motion + ofReadout * readout, in standard deviations.
struct Row {
  Eigen::Matrix<double, 2, 6> ofPose;
  Eigen::Vector2d ofReadout;
  Eigen::Vector2d error;
};

Eigen::Matrix<double, 2, 3> projectionJacobian(const Eigen::Vector3d& p_m, const core::CameraModel& camera) {
  Eigen::Matrix<double, 2, 3> J;
  J << camera.fx_px / p_m.z(), 0, -camera.fx_px * p_m.x() / (p_m.z() * p_m.z()),  //
      0, camera.fy_px / p_m.z(), -camera.fy_px * p_m.y() / (p_m.z() * p_m.z());
  return J;
}

/// How far a point that is read later seems to have moved, per second of readout (m/s).
Eigen::Vector3d driftOf(const SeenPoint& seen, const Eigen::Vector3d& p_cam_m, const Twist& twist) {
  return seen.rowTime * (twist.rotation_radps.cross(p_cam_m) + twist.translation_mps);
}

struct Solution {
  Vector6 motion = Vector6::Zero();
  double information = 0.0;  ///< Of the readout, whatever the motion was.
  double weightedSum = 0.0;  ///< information times readout.
  [[nodiscard]] double readout_s() const { return information > 0.0 ? weightedSum / information : 0.0; }
};

/// Least squares over the rows, the motion eliminated (Schur complement). Too few: nothing.
std::optional<Solution> solve(const std::vector<Row>& rows) {
  if (rows.size() < kMinPoints) return std::nullopt;
  Matrix6 H = 1e-6 * Matrix6::Identity();
  Vector6 b = Vector6::Zero();
  Vector6 c = Vector6::Zero();
  Solution solution;
  for (const Row& row : rows) {
    H += row.ofPose.transpose() * row.ofPose;
    b += row.ofPose.transpose() * row.error;
    c += row.ofPose.transpose() * row.ofReadout;
    solution.information += row.ofReadout.squaredNorm();
    solution.weightedSum += row.ofReadout.dot(row.error);
  }
  const Eigen::LLT<Matrix6> factor(H);
  solution.information -= c.dot(factor.solve(c));
  solution.weightedSum -= c.dot(factor.solve(b));
  solution.motion = factor.solve(b - solution.readout_s() * c);
  return solution;
}

/// What is far off when all is fitted was no match.
void trim(std::vector<Row>& rows, const Solution& fitted) {
  const auto isFarOff = [&](const Row& row) {
    return (row.error - row.ofPose * fitted.motion - row.ofReadout * fitted.readout_s()).norm() > kTrimSigmas;
  };
  rows.erase(std::remove_if(rows.begin(), rows.end(), isFarOff), rows.end());
}

}  // namespace

ReadoutEstimator::ReadoutEstimator(double known_s, double sigma_s)
    : information_per_s2_(1.0 / (sigma_s * sigma_s)), weightedSum_per_s_(known_s * information_per_s2_) {}

void ReadoutEstimator::observe(double stamp_s, const Eigen::Isometry3d& T_map_cam, const core::CameraModel& camera,
                               std::map<PointId, SeenPoint> points) {
  const double since_s = images_.empty() ? 0.0 : stamp_s - images_.back().stamp_s;
  if (!images_.empty() && !(since_s > 0.0 && since_s < kLongestStep_s)) images_.clear();
  images_.push_back({stamp_s, T_map_cam, std::move(points)});
  if (images_.size() < kImages) return;
  compare(1, 2, camera);
  images_.pop_front();
}

void ReadoutEstimator::move(const Eigen::Isometry3d& correction) {
  for (Image& image : images_) image.T_map_cam = correction * image.T_map_cam;
}

Twist ReadoutEstimator::twistAt(std::size_t image) const {
  const Image& before = images_[image - 1];
  const Image& behind = images_[image + 1];
  return twistOf(before.T_map_cam.inverse() * behind.T_map_cam, behind.stamp_s - before.stamp_s);
}

void ReadoutEstimator::compare(std::size_t before, std::size_t now, const core::CameraModel& camera) {
  const Twist twistBefore = twistAt(before);
  const Twist twistNow = twistAt(now);
  const double turn_radps = std::max(twistBefore.rotation_radps.norm(), twistNow.rotation_radps.norm());
  if (turn_radps < kLeastTurn_radps) return;
  const Eigen::Isometry3d T_now_before = images_[now].T_map_cam.inverse() * images_[before].T_map_cam;
  std::vector<Row> rows;
  for (const auto& [id, there] : images_[before].points) {
    const auto found = images_[now].points.find(id);
    if (found == images_[now].points.end() || there.depth_m <= 0.0) continue;
    const SeenPoint& here = found->second;
    const Eigen::Vector3d p_before_m = camera.unproject(there.undistorted_px, there.depth_m);
    const Eigen::Vector3d p_m = T_now_before * p_before_m;
    if (p_m.z() < kNearest_m) continue;
    const Eigen::Matrix<double, 2, 3> J = projectionJacobian(p_m, camera) / (kPixelSigma_px * here.scale);
    Row row;
    row.ofPose << J, -J * core::crossProductWith(p_m);
    row.ofReadout =
        J * (T_now_before.linear() * driftOf(there, p_before_m, twistBefore) - driftOf(here, p_m, twistNow));
    row.error = (here.undistorted_px - camera.project(p_m)) / (kPixelSigma_px * here.scale);
    rows.push_back(row);
  }
  const auto rough = solve(rows);
  if (!rough) return;
  trim(rows, *rough);
  const auto fine = solve(rows);
  if (!fine) return;
  information_per_s2_ += fine->information / kPointsPerOpinion;
  weightedSum_per_s_ += fine->weightedSum / kPointsPerOpinion;
}

double ReadoutEstimator::readout_s() const {
  const double likeliest_s = weightedSum_per_s_ / information_per_s2_;
  if (std::abs(likeliest_s) < kSureSigmas * sigma_s()) return 0.0;
  return std::clamp(likeliest_s, -kLongest_s, kLongest_s);
}

double ReadoutEstimator::sigma_s() const { return 1.0 / std::sqrt(information_per_s2_); }

}  // namespace wardslam::odometry
