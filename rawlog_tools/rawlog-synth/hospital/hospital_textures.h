#pragma once

#include <cstdint>
#include <map>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "textures/textures.h"

namespace wardslam::synth {

/// Of a texture that repeats.
constexpr float kFloorTexture_m = 9.6F;  ///< A whole number of tiles, both ways.
constexpr float kFloorTile_m = 0.6F;
constexpr float kCeilingTexture_m = 7.2F;
constexpr float kWallTexture_m = 12.0F;  ///< Along the wall; upwards it covers the whole height.

/// Textures for surfaces of any size, as a building is too large to have each painted. `signs`: what the cells of the
/// texture of signs say.
[[nodiscard]] std::map<Material, cv::Mat> paintHospitalTextures(float height_m, const std::vector<std::string>& signs,
                                                                std::uint32_t seed);

}  // namespace wardslam::synth
