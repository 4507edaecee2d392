#pragma once

#include "people/look.h"
#include "scene/mesh.h"

namespace wardslam::synth {

/// What the limbs do.
struct Posture {
  double stride_rad = 0.0;  ///< Phase of the walk; one cycle = two steps.
  double swing = 0.0;       ///< 0 standing … 1 walking briskly.
  double reaching = 0.0;    ///< 0 arms hang and swing … 1 both hands on a handle in front.
};

/// A body in the plain clothes of those who live in ward and floor or lie in a bed: short sleeves, trousers, a shirt or
/// a tunic. Feet on the floor, x to the front, z up; textured as the namespace outfit says.
[[nodiscard]] Mesh posePerson(const Look& look, const Posture& posture);

}  // namespace wardslam::synth
