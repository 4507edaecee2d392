#include "camera_motion.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>

#include "wardslam/core/rigid_transform.h"
#include "wardslam/core/rotation_vector.h"

namespace wardslam::change {
namespace {

using Matches = std::vector<PointMatch>;

constexpr int kColumns = 8;
constexpr int kRows = 6;
constexpr double kMostPerCell = 1.5;  // weight: a handful of points
constexpr int kMaxDraws = 100;
constexpr std::size_t kMinMatches = 6;
constexpr double kBelieved = 0.65;  // weight from which a match counts as known to be static
constexpr double kCredible = 0.4;   // mean weight below which a consensus is that of movers
constexpr double kMajority = 0.6;   // of what is known to be static must agree
constexpr double kSharp_px = 1.0;   // noise of a point in a sharp image
constexpr double kDepthCalibration = 0.01;
constexpr double kSteepSlope = 1.7;  // tangent of 60 degrees

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

class Consensus {
 public:
  Consensus(const Matches& matches, const core::CameraModel& camera) : matches_(matches), camera_(camera) {
    std::array<double, kColumns * kRows> sums{};
    for (const PointMatch& match : matches) {
      cells_.push_back(cellOf(match.b_px));
      sums[cells_.back()] += match.weight;
    }
    for (std::size_t i = 0; i < matches.size(); ++i) {
      says_.push_back(matches[i].weight * std::min(1.0, kMostPerCell / std::max(sums[cells_[i]], 1e-9)));
    }
  }

  /// What each match has to say: its weight, shared with those of its cell where they are many.
  [[nodiscard]] const std::vector<double>& says() const { return says_; }

  [[nodiscard]] double error(std::size_t i, const Eigen::Isometry3d& T_b_a) const {
    return squaredError(matches_[i], T_b_a, camera_);
  }

  /// Sum over the cells of what agrees, the better the more (MSAC), each cell capped.
  [[nodiscard]] double score(const Eigen::Isometry3d& T_b_a) const {
    std::array<double, kColumns * kRows> votes{};
    for (std::size_t i = 0; i < matches_.size(); ++i) {
      const double e = error(i, T_b_a);
      if (e < kChiSquare99) votes[cells_[i]] += matches_[i].weight * (1.0 - 0.7 * e / kChiSquare99);
    }
    return std::accumulate(votes.begin(), votes.end(), 0.0,
                           [](double sum, double vote) { return sum + std::min(vote, kMostPerCell); });
  }

  /// Share of what has a say that agrees.
  [[nodiscard]] double share(const Eigen::Isometry3d& T_b_a) const {
    double agree = 0;
    double all = 0;
    for (std::size_t i = 0; i < matches_.size(); ++i) {
      all += says_[i];
      if (error(i, T_b_a) < kChiSquare99) agree += says_[i];
    }
    return all > 0 ? agree / all : 0.0;
  }

  [[nodiscard]] std::vector<std::size_t> inliers(const Eigen::Isometry3d& T_b_a) const {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < matches_.size(); ++i) {
      if (error(i, T_b_a) < kChiSquare99) indices.push_back(i);
    }
    return indices;
  }

  [[nodiscard]] double noiseScale(const Eigen::Isometry3d& T_b_a) const {
    constexpr double kMedianOfChiSquare = 2.366;  // with 3 degrees of freedom
    std::vector<double> errors;
    for (std::size_t i = 0; i < matches_.size(); ++i) {
      if (matches_[i].weight > 0.49) errors.push_back(error(i, T_b_a));
    }
    return errors.empty() ? 1.0 : std::max(1.0, std::sqrt(medianOf(std::move(errors)) / kMedianOfChiSquare));
  }

  [[nodiscard]] double meanWeight(const std::vector<std::size_t>& indices) const {
    double sum = 0;
    for (const std::size_t i : indices) sum += matches_[i].weight;
    return indices.empty() ? 0.0 : sum / static_cast<double>(indices.size());
  }

  /// Share of the cells that have one of these matches.
  [[nodiscard]] double spread(const std::vector<std::size_t>& indices) const {
    std::array<bool, kColumns * kRows> isSeen{};
    for (const std::size_t i : indices) isSeen[cells_[i]] = true;
    return static_cast<double>(std::count(isSeen.begin(), isSeen.end(), true)) / (kColumns * kRows);
  }

 private:
  [[nodiscard]] std::size_t cellOf(const Eigen::Vector2d& px) const {
    const int column = std::clamp(static_cast<int>(px.x() * kColumns / camera_.width_px), 0, kColumns - 1);
    const int row = std::clamp(static_cast<int>(px.y() * kRows / camera_.height_px), 0, kRows - 1);
    return static_cast<std::size_t>(row * kColumns + column);
  }

  const Matches& matches_;
  const core::CameraModel& camera_;
  std::vector<std::size_t> cells_;
  std::vector<double> says_;
};

cv::Matx33d cameraMatrix(const core::CameraModel& camera) {
  return {camera.fx_px, 0, camera.cx_px, 0, camera.fy_px, camera.cy_px, 0, 0, 1};
}

Eigen::Isometry3d toIsometry(const cv::Vec3d& rotation, const cv::Vec3d& translation) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d axis(rotation[0], rotation[1], rotation[2]);
  if (axis.norm() > 0) T.linear() = Eigen::AngleAxisd(axis.norm(), axis.normalized()).toRotationMatrix();
  T.translation() = Eigen::Vector3d(translation[0], translation[1], translation[2]);
  return T;
}

void appendPoint(const PointMatch& match, std::vector<cv::Point3d>& points_a, std::vector<cv::Point2d>& pixels_b) {
  points_a.emplace_back(match.p_a_m.x(), match.p_a_m.y(), match.p_a_m.z());
  pixels_b.emplace_back(match.b_px.x(), match.b_px.y());
}

/// Draws indices with a probability that goes with their weight.
class WeightedDraw {
 public:
  explicit WeightedDraw(const std::vector<double>& weights) {
    std::partial_sum(weights.begin(), weights.end(), std::back_inserter(sums_));
  }
  [[nodiscard]] std::size_t operator()(cv::RNG& random) const {
    const double at = random.uniform(0.0, sums_.back());
    const auto found = std::upper_bound(sums_.begin(), sums_.end(), at);
    return static_cast<std::size_t>(std::min(found - sums_.begin(), static_cast<std::ptrdiff_t>(sums_.size()) - 1));
  }

 private:
  std::vector<double> sums_;
};

std::vector<Eigen::Isometry3d> motionsOfThree(const Matches& matches, const WeightedDraw& draw, cv::RNG& random,
                                              const cv::Matx33d& K) {
  const std::array<std::size_t, 3> drawn = {draw(random), draw(random), draw(random)};
  if (drawn[0] == drawn[1] || drawn[1] == drawn[2] || drawn[0] == drawn[2]) return {};
  std::vector<cv::Point3d> points_a;
  std::vector<cv::Point2d> pixels_b;
  for (const std::size_t i : drawn) appendPoint(matches[i], points_a, pixels_b);
  std::vector<cv::Vec3d> rotations;
  std::vector<cv::Vec3d> translations;
  const int solutions = cv::solveP3P(points_a, pixels_b, K, cv::noArray(), rotations, translations, cv::SOLVEPNP_AP3P);
  std::vector<Eigen::Isometry3d> motions;
  for (int i = 0; i < solutions; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (cv::checkRange(rotations[k]) && cv::checkRange(translations[k])) {
      motions.push_back(toIsometry(rotations[k], translations[k]));
    }
  }
  return motions;
}

/// Least squares over the reprojection of the matches named (Gauss and Newton: they agree already).
Eigen::Isometry3d refine(const Matches& matches, const std::vector<std::size_t>& inliers,
                         const core::CameraModel& camera, const Eigen::Isometry3d& T_b_a) {
  constexpr int kMostRounds = 8;
  constexpr double kStill = 1e-7;  // m, and rad
  Eigen::Isometry3d T = T_b_a;
  for (int round = 0; round < kMostRounds; ++round) {
    Eigen::Matrix<double, 6, 6> H = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> gradient = Eigen::Matrix<double, 6, 1>::Zero();
    for (const std::size_t i : inliers) {
      const Eigen::Vector3d p_b = T * matches[i].p_a_m;
      Eigen::Matrix<double, 2, 3> ofPoint;
      ofPoint << camera.fx_px, 0.0, -camera.fx_px * p_b.x() / p_b.z(),  //
          0.0, camera.fy_px, -camera.fy_px * p_b.y() / p_b.z();
      Eigen::Matrix<double, 2, 6> J;
      J << ofPoint, -ofPoint * core::crossProductWith(p_b);
      J /= p_b.z();
      H.noalias() += J.transpose() * J;
      gradient.noalias() += J.transpose() * (camera.project(p_b) - matches[i].b_px);
    }
    const Eigen::Matrix<double, 6, 1> step = -H.ldlt().solve(gradient);
    if (!step.allFinite()) return T_b_a;
    T = core::rigid(core::motionBy(step.head<3>(), step.tail<3>()) * T);
    if (step.cwiseAbs().maxCoeff() < kStill) break;
  }
  return T;
}

/// So many draws find three static matches among so many with a probability of 99.9 %.
int drawsNeeded(double staticShare) {
  const double allStatic = std::pow(std::clamp(staticShare, 0.05, 0.98), 3);
  return std::min(kMaxDraws, static_cast<int>(std::ceil(std::log(1e-3) / std::log(1.0 - allStatic))));
}

/// The motion most of these matches agree with; when fewer than `minShare` do, it need not be found.
Eigen::Isometry3d search(const Matches& matches, const core::CameraModel& camera,
                         const std::vector<Eigen::Isometry3d>& guesses, double minShare) {
  const Consensus consensus(matches, camera);
  const cv::Matx33d K = cameraMatrix(camera);
  Eigen::Isometry3d T_b_a = guesses.empty() ? Eigen::Isometry3d::Identity() : guesses.front();
  double best = -1.0;
  const auto consider = [&](const Eigen::Isometry3d& candidate) {
    const double score = consensus.score(candidate);
    if (score <= best) return;
    best = score;
    T_b_a = candidate;
  };
  const auto polish = [&] {
    const auto inliers = consensus.inliers(T_b_a);
    if (inliers.size() >= kMinMatches) consider(refine(matches, inliers, camera, T_b_a));
  };

  for (const Eigen::Isometry3d& guess : guesses) consider(guess);
  polish();
  const auto draws = [&] { return drawsNeeded(std::max(minShare, consensus.share(T_b_a))); };
  const WeightedDraw draw(consensus.says());
  cv::RNG random(0x5eed);
  for (int drawn = 0, needed = draws(); drawn < needed; ++drawn) {
    for (const Eigen::Isometry3d& candidate : motionsOfThree(matches, draw, random, K)) consider(candidate);
    needed = draws();
  }
  polish();
  polish();
  return T_b_a;
}

Matches knownToRest(const Matches& matches) {
  Matches known;
  std::copy_if(matches.begin(), matches.end(), std::back_inserter(known),
               [](const PointMatch& match) { return match.weight > kBelieved; });
  return known;
}

/// Whether the images may be blurred by motion, so that the noise expected is more than that of sharp ones.
bool isFast(const Matches& matches) {
  return 2 * std::count_if(matches.begin(), matches.end(), [](const auto& m) { return m.sigma_px > 1.5 * kSharp_px; }) >
         static_cast<std::ptrdiff_t>(matches.size());
}

Matches asIfSharp(Matches matches) {
  for (PointMatch& match : matches) match.sigma_px = std::min(match.sigma_px, kSharp_px);
  return matches;
}

}  // namespace

double squaredError(const PointMatch& match, const Eigen::Isometry3d& T_b_a, const core::CameraModel& camera) {
  const Eigen::Vector3d p_b = T_b_a * match.p_a_m;
  if (p_b.z() < 0.05) return std::numeric_limits<double>::infinity();
  double error = (camera.project(p_b) - match.b_px).squaredNorm() / (match.sigma_px * match.sigma_px);
  if (match.bDepth_m > 0) {
    const double sigma_a = camera.depthNoise.sigma_m(match.p_a_m.z());
    const double sigma_b = camera.depthNoise.sigma_m(match.bDepth_m);
    const double calibration = kDepthCalibration * match.bDepth_m;
    const double steep = kSteepSlope * match.sigma_px / camera.fx_px * match.bDepth_m;
    const double depth_m = match.bDepth_m - p_b.z();
    error += depth_m * depth_m / (sigma_a * sigma_a + sigma_b * sigma_b + calibration * calibration + steep * steep);
  }
  return error;
}

CameraMotion CameraMotionEstimator::estimate(const Matches& matches, const core::CameraModel& camera,
                                             const std::vector<Eigen::Isometry3d>& guesses) const {
  const Matches known = knownToRest(matches);
  CameraMotion motion;
  for (const Matches* asked : {&known, &matches}) {
    if (isFast(*asked)) {
      motion = estimateFrom(asIfSharp(*asked), camera, guesses, kMajority);
      motion.noiseScale = Consensus(*asked, camera).noiseScale(motion.T_b_a);
      if (motion.isTrusted) return motion;
    }
    motion = estimateFrom(*asked, camera, guesses, asked == &known ? kMajority : 0.0);
    if (motion.isTrusted) return motion;
  }
  return motion;
}

CameraMotion CameraMotionEstimator::estimateFrom(const Matches& matches, const core::CameraModel& camera,
                                                 const std::vector<Eigen::Isometry3d>& guesses, double minShare) const {
  CameraMotion motion;
  if (matches.size() < kMinMatches) return motion;
  motion.T_b_a = search(matches, camera, guesses, minShare);
  const Consensus consensus(matches, camera);
  const auto inliers = consensus.inliers(motion.T_b_a);
  motion.noiseScale = consensus.noiseScale(motion.T_b_a);
  motion.isTrusted = static_cast<int>(inliers.size()) >= options_.min_points &&
                     consensus.spread(inliers) >= options_.min_spread && consensus.share(motion.T_b_a) >= minShare &&
                     consensus.meanWeight(inliers) >= kCredible;
  return motion;
}

}  // namespace wardslam::change
