#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "life/ways.h"
#include "scene/scene.h"

namespace wardslam::synth {

enum class Density { None, Few, Normal, Busy, Crowd };

/// none, few, normal, busy, crowd.
[[nodiscard]] const std::map<std::string, Density>& densities();

struct LifeOptions {
  Density density = Density::Normal;
  std::uint32_t seed = 1;
  double duration_s = 900.0;  ///< So long the camera's way is kept free of those who rest.
};

/// Fills a place with people who walk, stand, sit, talk and move things about. Adds them, and what they bring, as
/// instances `firstId` and up; some of what `ways` says can be moved turns from a thing of the scene into an actor and
/// keeps its label. Indices into Scene::things, those of `ways` too, are void after that. The same options and place
/// give the same life. Throws std::invalid_argument when the ways cannot be walked. Returns the next free id.
std::uint16_t addLife(Scene& scene, std::uint16_t firstId, const Ways& ways, const LifeOptions& options);

}  // namespace wardslam::synth
