#pragma once

#include <filesystem>

#include "wardslam/evaluation/room_evaluation.h"

namespace wardslam::evaluation {

/// Rooms and doors of a storey from the rooms.geojson that rawlog-synth writes: features whose property `what` is
/// `room` (a polygon; id, name) or `door` (a line; rooms, state, open_rad). Others are left out. Throws
/// core::InputError naming the file.
[[nodiscard]] TrueBuilding readTrueBuilding(const std::filesystem::path& file, int storey = 0);

}  // namespace wardslam::evaluation
