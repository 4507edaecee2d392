#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <vector>

#include "wardslam/core/camera_model.h"
#include "wardslam/odometry/depth_view.h"

namespace wardslam::odometry {

/// Small squares of the raw image, and where the middle of each looks; the same for all images of a camera.
struct SquareRays {
  SquareRays(const core::CameraModel& ofCamera, const cv::Size& size_px);

  core::CameraModel camera;
  int square_px = 1;
  int columns = 0;
  int rows = 0;
  std::vector<Eigen::Vector3f> rays;  ///< At a depth of one metre, row by row.
};

/// What one image shows of the surfaces at rest: a point for each small square of the raw image, and how it is turned.
/// For one thread at a time.
class DepthSurface {
 public:
  /// Squares that an edge runs through, that something moving covers, or that have no depth, have no point.
  DepthSurface(const DepthImage& image, const core::CameraModel& camera);
  /// `squares`: of images of this size.
  DepthSurface(const DepthImage& image, std::shared_ptr<const SquareRays> squares);

  [[nodiscard]] int columns() const { return squares_->columns; }
  [[nodiscard]] int rows() const { return squares_->rows; }
  [[nodiscard]] const core::CameraModel& camera() const { return squares_->camera; }

  /// In the camera frame (m); z = 0: none.
  [[nodiscard]] const Eigen::Vector3f& point(int column, int row) const { return points_[indexOf(column, row)]; }

  /// Of length 1, towards the camera, of the plane through the points up to two squares away that are of the same
  /// surface; zero where these are too few, or on one line.
  [[nodiscard]] const Eigen::Vector3f& normal(int column, int row) const;

  /// How far noise of depth may turn the normal of such a surface (standard deviation, rad).
  [[nodiscard]] double normalSigma_rad(const Eigen::Vector3d& p_cam_m, const Eigen::Vector3d& normal) const;

  /// The square that a point in the camera frame (m) falls into.
  [[nodiscard]] std::optional<Eigen::Vector2i> squareOf(const Eigen::Vector3d& p_cam_m) const;

 private:
  [[nodiscard]] std::size_t indexOf(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns()) + static_cast<std::size_t>(column);
  }

  std::shared_ptr<const SquareRays> squares_;
  [[nodiscard]] Eigen::Vector3f planeNormal(int column, int row) const;

  std::vector<Eigen::Vector3f> points_;
  mutable std::vector<std::optional<Eigen::Vector3f>> normals_;  ///< Of those that were asked for.
};

}  // namespace wardslam::odometry
