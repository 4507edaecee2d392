#pragma once

#include <opencv2/core.hpp>

#include "scene/scene.h"

/// Things of a hospital beyond those of furniture.h, in their own frames as there: origin on the floor, x to the front
/// (what stands or hangs at a wall: origin at the wall, x out of it), z up; metres.
namespace wardslam::synth {

[[nodiscard]] Surfaces makeWheelchair(cv::RNG& rng);
/// Three wings on feet, across x.
[[nodiscard]] Surfaces makeFoldingScreen(cv::RNG& rng);
[[nodiscard]] Surfaces makeShelf(float width_m, cv::RNG& rng);
/// Of a reception: people stand in front of it at x > 0.
[[nodiscard]] Surfaces makeCounter(float width_m, cv::RNG& rng);
[[nodiscard]] Surfaces makeToilet(cv::RNG& rng);
[[nodiscard]] Surfaces makeBasin(cv::RNG& rng);
[[nodiscard]] Surfaces makeDesk(cv::RNG& rng);

/// A leaf that hangs at the origin, closed along x; `opening_rad` turns it towards +y.
[[nodiscard]] Surfaces makeDoorLeaf(float width_m, float height_m, float opening_rad, cv::RNG& rng);
/// Origin in the middle of its sill, at the wall. `place`: which part of the view it shows, 0 to 1.
[[nodiscard]] Surfaces makeWindow(float width_m, float place, cv::RNG& rng);
/// `cell` of the texture of signs. Origin in its middle, at the wall.
[[nodiscard]] Surfaces makeSign(int cell, float width_m, cv::RNG& rng);
/// Seen from both sides; hangs from the ceiling, which is `drop_m` above its upper edge. Origin on the floor below.
[[nodiscard]] Surfaces makeHangingSign(int cell, float ceiling_m, cv::RNG& rng);
[[nodiscard]] Surfaces makeExtinguisher(cv::RNG& rng);
[[nodiscard]] Surfaces makeDispenser(cv::RNG& rng);
[[nodiscard]] Surfaces makeWhiteboard(cv::RNG& rng);

constexpr int kSignColumns = 4;
constexpr int kSignRows = 9;
constexpr float kSignAspect = 3.0F;  ///< Width to height.
constexpr float kWheelchairSeat_m = 0.52F;

}  // namespace wardslam::synth
