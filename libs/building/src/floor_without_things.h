#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "wardslam/mapping/floor_plan.h"
#include "wardslam/mapping/map_object.h"

namespace wardslam::building {

/// CV_8UC1, 255 where floor was seen free, or is between two looks; 0 elsewhere.
[[nodiscard]] cv::Mat seenFloor(const mapping::FloorPlan& plan);

/// CV_8UC1, 255 where there is floor, whether something stands on it or not; 0 where there are walls, or nobody looked.
[[nodiscard]] cv::Mat floorWithoutThings(const mapping::FloorPlan& plan,
                                         const std::vector<const mapping::MapObject*>& things);

}  // namespace wardslam::building
