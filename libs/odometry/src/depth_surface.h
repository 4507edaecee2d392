#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "wardslam/core/camera_model.h"
#include "wardslam/odometry/depth_view.h"

namespace wardslam::odometry {

/// What one image shows of the surfaces at rest: a point for each small square of the raw image, and how it is turned.
class DepthSurface {
 public:
  /// Squares that an edge runs through, that something moving covers, or that have no depth, have no point.
  DepthSurface(const DepthImage& image, const core::CameraModel& camera);

  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] const core::CameraModel& camera() const { return camera_; }

  /// In the camera frame (m); z = 0: none.
  [[nodiscard]] const Eigen::Vector3f& point(int column, int row) const { return points_[indexOf(column, row)]; }

  /// Of length 1, towards the camera, of the plane through the points up to two squares away that are of the same
  /// surface; zero where these are too few, or on one line.
  [[nodiscard]] Eigen::Vector3f normal(int column, int row) const;

  /// How far noise of depth may turn the normal of such a surface (standard deviation, rad).
  [[nodiscard]] double normalSigma_rad(const Eigen::Vector3d& p_cam_m, const Eigen::Vector3d& normal) const;

  /// The square that a point in the camera frame (m) falls into.
  [[nodiscard]] std::optional<Eigen::Vector2i> squareOf(const Eigen::Vector3d& p_cam_m) const;

 private:
  [[nodiscard]] std::size_t indexOf(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  core::CameraModel camera_;
  int square_px_ = 1;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<Eigen::Vector3f> points_;
};

}  // namespace wardslam::odometry
