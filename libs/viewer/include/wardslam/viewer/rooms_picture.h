#pragma once

#include <opencv2/core.hpp>

#include "wardslam/building/rooms.h"

namespace wardslam::viewer {

/// The rooms of a storey seen from above (CV_8UC3, BGR), each in a colour of its own with its name and area; doors as
/// lines. The map's y axis points up. Equal rooms give equal pictures; none give a small empty one.
[[nodiscard]] cv::Mat drawRooms(const building::Rooms& rooms);

}  // namespace wardslam::viewer
