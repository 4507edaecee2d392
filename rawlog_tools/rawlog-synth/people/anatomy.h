#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <opencv2/core.hpp>

#include "scene/mesh.h"

/// The human body under all clothes: how long its parts are, what they hang from and how that turns. What the parts
/// look like is up to who dresses it (person.h, figure.h). x to the front, z up.
namespace wardslam::synth::anatomy {

// Of a body of kReferenceHeight_m.
constexpr float kReferenceHeight_m = 1.75F;
constexpr float kThigh_m = 0.43F;
constexpr float kShin_m = 0.42F;
constexpr float kAnkle_m = 0.075F;
constexpr float kShoulderAboveHip_m = 0.5F;
constexpr float kUpperArm_m = 0.29F;
constexpr float kForearm_m = 0.25F;

/// How far in front of the body's middle the hands are when reaching for a handle.
constexpr float kReach_m = 0.5F;

/// Angles of a limb of two parts: the upper from the vertical, the lower against the upper one; positive is forward.
struct LimbAngles {
  double upper_rad = 0.0;
  double bend_rad = 0.0;
};

/// Of a pair: the right one, then the left one.
template <class T>
using Pair = std::array<T, 2>;
constexpr std::size_t kRight = 0;
constexpr std::size_t kLeft = 1;

/// What the joints do.
struct Stance {
  Pair<LimbAngles> legs;
  Pair<LimbAngles> arms;
  float legsApart_rad = 0.0F;  ///< Each leg turned outwards about the vertical.
  float armsAway_rad = 0.0F;   ///< Each arm hangs so far away from the body.
  double lean_rad = 0.0;       ///< Forward, of all above the hips.
  double headTurn_rad = 0.0;   ///< To the left.
  double hip_m = 0.0;          ///< Height of the joints over the floor; legLength() of the leg that stands.
};

/// What hangs on the joints, each in the frame of its own; of pairs one.
struct Parts {
  Mesh torso;  ///< The origin is between the hips; leans.
  Mesh head;   ///< The origin is the top of the neck.
  Mesh upperArm;
  Mesh forearm;
  Mesh hand;
  Mesh pelvis;  ///< The origin is between the hips; does not lean.
  Mesh thigh;
  Mesh shin;
  Mesh shoe;
  Mesh skirt;                        ///< Like the pelvis.
  float hip_m = 0.09F;               ///< From the middle to the side.
  float shoulder_m = 0.2F;           ///< Likewise.
  float shoulderDrop_m = 0.0F;       ///< Below kShoulderAboveHip_m.
  float elbowToHand_m = kForearm_m;  ///< To the origin of the hand.
};

/// Puts the parts together and makes the body that tall; the origin is on the floor under its hips.
[[nodiscard]] Mesh assemble(const Parts& parts, const Stance& stance, float height_m);

/// Both limbs of a pair swing with the stride, the left one as it says, the right one half a cycle apart.
[[nodiscard]] double phaseOf(std::size_t side, double stride_rad);
/// Of a leg that stands (`swing` 0) or walks briskly (1).
[[nodiscard]] LimbAngles walkingLeg(double swing, double phase_rad);

/// From the hip to the sole, at kReferenceHeight_m, as precisely as asked for.
template <class Real>
[[nodiscard]] Real legLength(const LimbAngles& leg) {
  return kThigh_m * static_cast<Real>(std::cos(leg.upper_rad)) +
         kShin_m * static_cast<Real>(std::cos(leg.upper_rad + leg.bend_rad)) + kAnkle_m;
}

/// How far a body travels in one cycle of the walk, two steps.
[[nodiscard]] double strideLength_m(float height_m);

/// In that piece of the outfit's texture but for its rim, lest interpolation draws in the neighbour's colour.
[[nodiscard]] Mesh dressed(Mesh mesh, const cv::Rect2f& cloth, float rim);
/// With a flat sole kAnkle_m below its joint.
[[nodiscard]] Mesh makeShoe(float halfWidth_m, float forward_m);
/// Hair that leaves the face free: below the forehead, what is farther ahead than that is pushed to the back of it.
[[nodiscard]] Mesh cutFree(Mesh hair, float ahead_m);

}  // namespace wardslam::synth::anatomy
