#pragma once

#include "people/figure.h"

/// Parts of a body of 1.75 m, each in the frame of the joint it hangs from; used by poseFigure() only.
namespace wardslam::synth::figure {

constexpr float kThigh_m = 0.43F;
constexpr float kShin_m = 0.42F;
constexpr float kAnkle_m = 0.075F;
constexpr float kHipOffset_m = 0.088F;
constexpr float kShoulderAboveHip_m = 0.5F;
constexpr float kUpperArm_m = 0.29F;
constexpr float kForearm_m = 0.25F;

[[nodiscard]] float shoulderOffset_m(const Look& look);
[[nodiscard]] Mesh makeThigh(const Look& look);
[[nodiscard]] Mesh makeShin(const Look& look);
[[nodiscard]] Mesh makeShoe();
[[nodiscard]] Mesh makeUpperArm(const Look& look);
[[nodiscard]] Mesh makeForearm(const Look& look);
[[nodiscard]] Mesh makeHand();
[[nodiscard]] Mesh makePelvis(const Look& look);
/// From the hips to the neck; the origin is between the hips.
[[nodiscard]] Mesh makeTorso(const Look& look);
/// What of a tunic, coat or gown hangs below the hips, over thighs that are raised by these angles.
[[nodiscard]] Mesh makeSkirtOfGarment(const Look& look, double left_rad, double right_rad);
/// The origin is the top of the neck.
[[nodiscard]] Mesh makeHead(const Look& look);

}  // namespace wardslam::synth::figure
