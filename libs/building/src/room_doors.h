#pragma once

#include <vector>

#include "floor_regions.h"

namespace wardslam::building {

/// Where two regions touch, in cells.
struct RegionBorder {
  int region = 0;  ///< The smaller id of both.
  int other = 0;
  std::vector<cv::Point> cells;
  cv::Point from;  ///< Ends of the shortest line from wall to wall through its widest place.
  cv::Point to;
  float halfWidth = 0.0F;  ///< From its widest place to the nearest wall.
};

/// In the order of the regions' ids; of two regions there may be several.
[[nodiscard]] std::vector<RegionBorder> bordersOf(const FloorRegions& regions);

}  // namespace wardslam::building
