#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "hospital/hospital_plan.h"

/// Where one drives in a hospital: nothing is put in these ways.
namespace wardslam::synth {

using Polyline = std::vector<Eigen::Vector2d>;

/// The place on the middle of the corridor in front of a room's door.
[[nodiscard]] Eigen::Vector2d frontOf(const HospitalPlan& plan, const Door& door);
/// Whether the rounds go into the room: wards whose door is open, lobby and day room.
[[nodiscard]] bool isVisited(const HospitalPlan& plan, const Door& door);
/// From the corridor into the room, around in it and back to where it began.
[[nodiscard]] Polyline visitTo(const HospitalPlan& plan, const Door& door);
/// From the corridor a step into a room that the rounds do not go into.
[[nodiscard]] Polyline doorstep(const HospitalPlan& plan, const Door& door);
/// The round within the room alone.
[[nodiscard]] Polyline roundIn(const Room& room);
/// Where a corridor and a crossing meet. `crossing`: 0 to 2, from west to east.
[[nodiscard]] Eigen::Vector2d junction(const HospitalPlan& plan, std::size_t corridor, std::size_t crossing);
/// Corridor A from end to end and back, turning at the crossings.
[[nodiscard]] Polyline alongCorridor(const HospitalPlan& plan);

/// All of it, to be kept clear.
[[nodiscard]] std::vector<Polyline> allDrives(const HospitalPlan& plan);
[[nodiscard]] double distanceTo(const Polyline& line, const Eigen::Vector2d& p_m);

}  // namespace wardslam::synth
