#pragma once

#include <cstddef>
#include <opencv2/core.hpp>

#include "people/figure.h"

namespace wardslam::synth {

enum class Role { Nurse, Doctor, Porter, Visitor, Patient };

/// Textures of clothes beyond those of Material's enumerators: numbered from here on.
[[nodiscard]] Material lifeOutfit(std::size_t number);

/// How many of them there are.
[[nodiscard]] std::size_t lifeOutfitCount();

/// Paints one of them: CV_8UC3, BGR, 384 × 384. The same seed paints the same bytes.
[[nodiscard]] cv::Mat paintLifeOutfit(Material outfit, std::uint32_t seed);

/// Somebody of that role: height, girth, hair and clothes by chance.
[[nodiscard]] Look randomLook(Role role, cv::RNG& rng);

}  // namespace wardslam::synth
