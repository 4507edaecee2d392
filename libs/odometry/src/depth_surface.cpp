#include "depth_surface.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace wardslam::odometry {
namespace {

constexpr int kMostColumns = 160;
constexpr int kLeastSquare_px = 4;                       // smaller ones leave normals to noise
constexpr int kReach = 2;                                // squares around to the points a normal is made of
constexpr double kLeastScatter = 2.0 * kReach * kReach;  // of these, square: as of two points as far apart as can be
constexpr double kEdge_m = 0.02;     // what depth may differ by on a slanted surface, within a square, ...
constexpr double kEdgeShare = 0.02;  // ... the more the farther away, ...
constexpr double kEdgeSigmas = 4.0;  // ... besides noise
constexpr double kAveraged = 2.0;    // what the mean over a square takes off: its pixels are wrong together in part
constexpr double kMinPixels = 0.5;   // of a square

float edge_m(float depth_m, const core::DepthNoise& noise) {
  const auto z_m = static_cast<double>(depth_m);
  return static_cast<float>(kEdge_m + kEdgeShare * z_m + kEdgeSigmas * noise.sigma_m(z_m));
}

bool isCovered(const cv::Mat& mayMove, const cv::Rect& square) {
  for (int y = square.y; y < square.y + square.height; ++y) {
    const auto* moves = mayMove.ptr<std::uint8_t>(y);
    if (std::any_of(moves + square.x, moves + square.x + square.width, [](std::uint8_t m) { return m != 0; }))
      return true;
  }
  return false;
}

/// Mean depth of a square (m); 0 where it is not one surface.
float depthOf(const DepthImage& image, const cv::Rect& square, const core::DepthNoise& noise) {
  float sum_m = 0.0F;
  float nearest_m = 0.0F;
  float farthest_m = 0.0F;
  int measured = 0;
  for (int y = square.y; y < square.y + square.height; ++y) {
    const auto* depth_m = image.depth_m.ptr<float>(y);
    for (int x = square.x; x < square.x + square.width; ++x) {
      if (!(depth_m[x] > 0.0F)) continue;
      nearest_m = measured == 0 ? depth_m[x] : std::min(nearest_m, depth_m[x]);
      farthest_m = std::max(farthest_m, depth_m[x]);
      sum_m += depth_m[x];
      ++measured;
    }
  }
  const bool isOne = measured >= kMinPixels * square.area() && farthest_m - nearest_m < edge_m(nearest_m, noise);
  return isOne ? sum_m / static_cast<float>(measured) : 0.0F;
}

double smallerEigenvalue(const Eigen::Matrix2d& A) {
  const double half = 0.5 * A.trace();
  return half - std::sqrt(std::max(0.0, half * half - A.determinant()));
}

}  // namespace

SquareRays::SquareRays(const core::CameraModel& ofCamera, const cv::Size& size_px) : camera(ofCamera) {
  square_px = std::max(kLeastSquare_px, size_px.width / kMostColumns);
  columns = size_px.width / square_px;
  rows = size_px.height / square_px;
  std::vector<cv::Point2f> centres_px;
  const float half_px = 0.5F * static_cast<float>(square_px - 1);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      centres_px.emplace_back(static_cast<float>(column * square_px) + half_px,
                              static_cast<float>(row * square_px) + half_px);
    }
  }
  rays.reserve(centres_px.size());
  for (const cv::Point2f& px : camera.undistort(centres_px)) {
    rays.push_back(camera.unproject(Eigen::Vector2d(px.x, px.y), 1.0).cast<float>());
  }
}

DepthSurface::DepthSurface(const DepthImage& image, const core::CameraModel& camera)
    : DepthSurface(image, std::make_shared<SquareRays>(camera, image.depth_m.size())) {}

DepthSurface::DepthSurface(const DepthImage& image, std::shared_ptr<const SquareRays> squares)
    : squares_(std::move(squares)) {
  const int side_px = squares_->square_px;
  const bool mayMove = image.mayMove.size() == image.depth_m.size();
  points_.reserve(squares_->rays.size());
  for (int row = 0; row < rows(); ++row) {
    for (int column = 0; column < columns(); ++column) {
      const cv::Rect square(column * side_px, row * side_px, side_px, side_px);
      const bool isLeftOut = mayMove && isCovered(image.mayMove, square);
      const float depth_m = isLeftOut ? 0.0F : depthOf(image, square, camera().depthNoise);
      points_.push_back(depth_m * squares_->rays[points_.size()]);
    }
  }
  normals_.resize(points_.size());
}

const Eigen::Vector3f& DepthSurface::normal(int column, int row) const {
  auto& known = normals_[indexOf(column, row)];
  if (!known) known = planeNormal(column, row);
  return *known;
}

/// On a plane n . p = d inverse depth is linear in where the ray goes: 1 / z = (n / d) . (p / z).
Eigen::Vector3f DepthSurface::planeNormal(int column, int row) const {
  const Eigen::Vector3f& here = point(column, row);
  if (here.z() <= 0.0F) return Eigen::Vector3f::Zero();
  Eigen::Matrix3d ofRays = Eigen::Matrix3d::Zero();
  Eigen::Vector3d ofInverseDepths = Eigen::Vector3d::Zero();
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  int count = 0;
  const float limit_m = static_cast<float>(2 * kReach) * edge_m(here.z(), camera().depthNoise);
  for (int y = std::max(row - kReach, 0); y <= std::min(row + kReach, rows() - 1); ++y) {
    for (int x = std::max(column - kReach, 0); x <= std::min(column + kReach, columns() - 1); ++x) {
      const Eigen::Vector3f& p_m = point(x, y);
      if (p_m.z() <= 0.0F || std::abs(p_m.z() - here.z()) > limit_m) continue;
      const double inverseDepth = 1.0 / static_cast<double>(p_m.z());
      const Eigen::Vector3d ray = p_m.cast<double>() * inverseDepth;
      ofRays += ray * ray.transpose();
      ofInverseDepths += inverseDepth * ray;
      const Eigen::Vector2d offset(x - column, y - row);
      sum += offset;
      scatter += offset * offset.transpose();
      ++count;
    }
  }
  scatter -= sum * sum.transpose() / count;
  if (smallerEigenvalue(scatter) < kLeastScatter) return Eigen::Vector3f::Zero();
  return -ofRays.ldlt().solve(ofInverseDepths).normalized().cast<float>();
}

/// Across the surface depth is wrong by sigma * c, over a length of span / c, where c is the cosine between normal and
/// ray.
double DepthSurface::normalSigma_rad(const Eigen::Vector3d& p_cam_m, const Eigen::Vector3d& normal) const {
  const double span_m = 2.0 * kReach * squares_->square_px * p_cam_m.z() / camera().fx_px;
  const double sigma_m = std::sqrt(2.0) * camera().depthNoise.sigma_m(p_cam_m.z()) / kAveraged;
  const double c = normal.dot(p_cam_m) / p_cam_m.norm();
  return c * c * sigma_m / span_m;
}

std::optional<Eigen::Vector2i> DepthSurface::squareOf(const Eigen::Vector3d& p_cam_m) const {
  const auto raw_px = camera().seenAt(p_cam_m);
  if (!raw_px) return std::nullopt;
  const Eigen::Vector2i square((raw_px->array() + 0.5).cast<int>() / squares_->square_px);
  if (square.x() >= columns() || square.y() >= rows()) return std::nullopt;
  return square;
}

}  // namespace wardslam::odometry
