#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "wardslam/core/camera_model.h"
#include "wardslam/core/keypoint.h"

namespace wardslam::odometry {

/// Finds the key points near a pixel without looking at all of them.
class KeypointGrid {
 public:
  KeypointGrid(const std::vector<core::Keypoint>& keypoints, const core::CameraModel& camera);

  /// Calls `visit(index)` for every key point within `radius_px` (undistorted pixels), in a fixed order.
  template <class Visitor>
  void forEachNear(const Eigen::Vector2d& undistorted_px, double radius_px, Visitor&& visit) const {
    const int firstCol = column(undistorted_px.x() - radius_px);
    const int lastCol = column(undistorted_px.x() + radius_px);
    const int firstRow = row(undistorted_px.y() - radius_px);
    const int lastRow = row(undistorted_px.y() + radius_px);
    for (int r = firstRow; r <= lastRow; ++r) {
      for (int c = firstCol; c <= lastCol; ++c) {
        for (const std::size_t index : cells_[cellAt(r, c)]) {
          const auto& pixel = (*keypoints_)[index].undistorted_px;
          const Eigen::Vector2d offset_px(pixel.x - undistorted_px.x(), pixel.y - undistorted_px.y());
          if (offset_px.squaredNorm() <= radius_px * radius_px) visit(index);
        }
      }
    }
  }

 private:
  static constexpr double kCellSize_px = 20.0;

  [[nodiscard]] int column(double x_px) const;
  [[nodiscard]] int row(double y_px) const;
  [[nodiscard]] std::size_t cellAt(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  const std::vector<core::Keypoint>* keypoints_;
  int columns_;
  int rows_;
  std::vector<std::vector<std::size_t>> cells_;
};

}  // namespace wardslam::odometry
