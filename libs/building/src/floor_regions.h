#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

namespace wardslam::building {

struct RegionOptions {
  double widestDoor = 0.0;      ///< Cells.
  double smallestRegion = 0.0;  ///< Cells.
};

/// Parts of a floor between which it is narrow.
struct FloorRegions {
  cv::Mat ids;                     ///< CV_32SC1: 1 to `middles.size()`, 0 where there is no floor.
  cv::Mat distance;                ///< CV_32FC1, cells: from the middle of each cell to the nearest wall.
  std::vector<cv::Point> middles;  ///< Of region i + 1: the cell farthest from walls. In the order of rows.
};

/// Cuts the floor (CV_8UC1, not 0 where there is some) at its narrow places, see findRooms().
[[nodiscard]] FloorRegions cutAtNarrowPlaces(const cv::Mat& floor, const RegionOptions& options);

}  // namespace wardslam::building
