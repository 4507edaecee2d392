#pragma once

#include "life/steering.h"

namespace wardslam::synth {

/// Gives a member something to do, beginning where it is.
void takeErrand(const SocietyWorld& world, SocietyState& state, std::size_t who, double t_s);

/// Lets some of those around the camera keep it company, at times; `t_s` now.
void callEscorts(const SocietyWorld& world, SocietyState& state, double t_s);

/// Where place `index` around the camera is at `t_s`: on its further way.
[[nodiscard]] Eigen::Vector2d escortPlace(const SocietyWorld& world, std::size_t index, double t_s);

/// A number from 0 to 1; moves the dice on.
[[nodiscard]] double rollDice(std::uint64_t& dice);

}  // namespace wardslam::synth
