#pragma once

#include <cstddef>
#include <vector>

#include "hospital/hospital_plan.h"
#include "scene/scene.h"

/// Storeys one above the other, the lowest at z = 0.
namespace wardslam::synth {

[[nodiscard]] constexpr float floorZOf(int storey) { return kStoreyHeight_m * static_cast<float>(storey); }
/// Of so many; what is below or above all of them counts to the nearest.
[[nodiscard]] int storeyAt(double z_m, std::size_t storeys);

/// One scene of storeys that have each been built at z = 0, with the textures of the one that is driven on: no other is
/// ever seen. One storey stays as it is.
[[nodiscard]] Scene stacked(std::vector<Scene> storeys, std::size_t driven);

}  // namespace wardslam::synth
