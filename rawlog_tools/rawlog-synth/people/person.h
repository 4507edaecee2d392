#pragma once

#include "scene/mesh.h"

namespace wardslam::synth {

enum class HairStyle { Short, Bun, Long };
enum class Clothing { Tunic, Shirt };

struct Body {
  float height_m = 1.75F;
  float girth = 1.0F;  ///< 1 = slim.
  HairStyle hair = HairStyle::Short;
  Clothing clothing = Clothing::Shirt;
};

/// What the limbs do.
struct Posture {
  double stride_rad = 0.0;  ///< Phase of the walk; one cycle = two steps.
  double swing = 0.0;       ///< 0 standing … 1 walking briskly.
  double reaching = 0.0;    ///< 0 arms hang and swing … 1 both hands on a handle in front.
};

/// A person, feet on the floor, x to the front, z up; textured as the namespace outfit says.
[[nodiscard]] Mesh posePerson(const Body& body, const Posture& posture);

/// How far a body travels in one cycle of the walk.
[[nodiscard]] double strideLength_m(const Body& body);

/// How far in front of the body's middle the hands are when reaching.
constexpr float kReach_m = 0.5F;

}  // namespace wardslam::synth
