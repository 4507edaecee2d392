#include "wardslam/odometry/keypoint_grid.h"

#include <algorithm>

namespace wardslam::odometry {

KeypointGrid::KeypointGrid(const std::vector<core::Keypoint>& keypoints, const core::CameraModel& camera)
    : keypoints_(&keypoints),
      columns_(static_cast<int>(camera.width_px / kCellSize_px) + 1),
      rows_(static_cast<int>(camera.height_px / kCellSize_px) + 1),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {
  for (std::size_t i = 0; i < keypoints.size(); ++i) {
    const auto& pixel = keypoints[i].undistorted_px;
    cells_[cellAt(row(static_cast<double>(pixel.y)), column(static_cast<double>(pixel.x)))].push_back(i);
  }
}

int KeypointGrid::column(double x_px) const {
  return static_cast<int>(std::clamp(x_px / kCellSize_px, 0.0, static_cast<double>(columns_ - 1)));
}

int KeypointGrid::row(double y_px) const {
  return static_cast<int>(std::clamp(y_px / kCellSize_px, 0.0, static_cast<double>(rows_ - 1)));
}

}  // namespace wardslam::odometry
