#pragma once

#include <opencv2/core.hpp>

#include "scene/scene.h"

/// Things of a ward in their own frames: origin on the floor, x to the front (what hangs on a wall: origin on the
/// wall, x out of it), z up; metres.
namespace wardslam::synth {

/// Gathers surfaces; gives each mesh its own place on the texture, so that no two things look alike.
class Assembly {
 public:
  explicit Assembly(cv::RNG& rng) : rng_(rng) {}

  /// For textures that repeat.
  void add(Material material, Mesh mesh);
  /// For textures with fixed places (posters, screens).
  void addExact(Material material, const Mesh& mesh);
  [[nodiscard]] Surfaces take() { return std::move(surfaces_); }

 private:
  cv::RNG& rng_;
  Surfaces surfaces_;
};

constexpr float kBedLength_m = 2.1F;
constexpr float kBedWidth_m = 0.96F;

/// Origin under the middle of the head end, x towards the foot end.
[[nodiscard]] Surfaces makeBed(int chart, cv::RNG& rng);
[[nodiscard]] Surfaces makeChair(cv::RNG& rng);
[[nodiscard]] Surfaces makeBedsideCabinet(cv::RNG& rng);
[[nodiscard]] Surfaces makeIvStand(cv::RNG& rng);
[[nodiscard]] Surfaces makeTable(cv::RNG& rng);
[[nodiscard]] Surfaces makePlant(cv::RNG& rng);
[[nodiscard]] Surfaces makeTrashBin(cv::RNG& rng);

/// Pushed along x by somebody behind it; the handle is at x = kTrolleyHandleX_m, z = kTrolleyHandleZ_m.
[[nodiscard]] Surfaces makeTrolley(cv::RNG& rng);
constexpr float kTrolleyHandleX_m = -0.5F;
constexpr float kTrolleyHandleZ_m = 1.02F;

/// A curtain on its rail, along x from the origin.
[[nodiscard]] Surfaces makeCurtain(float length_m, float railLength_m, float ceiling_m, cv::RNG& rng);

/// Wall things: the origin is the middle of the thing.
[[nodiscard]] Surfaces makePicture(int poster, float width_m, cv::RNG& rng);
[[nodiscard]] Surfaces makePatientMonitor(cv::RNG& rng);
[[nodiscard]] Surfaces makeTelevision(cv::RNG& rng);
[[nodiscard]] Surfaces makeOutletPanel(cv::RNG& rng);

}  // namespace wardslam::synth
