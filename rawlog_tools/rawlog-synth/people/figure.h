#pragma once

#include "people/anatomy.h"
#include "people/look.h"
#include "scene/mesh.h"

namespace wardslam::synth {

/// What a body does. All parts can be mixed and change continuously.
struct FigurePose {
  double stride_rad = 0.0;  ///< Phase of the walk; one cycle = two steps.
  double swing = 0.0;       ///< 0 standing … 1 walking briskly.
  double sitting = 0.0;     ///< 0 upright … 1 on a seat.
  double seat_m = 0.48;     ///< Height of that seat.
  double footrest_m = 0.0;  ///< Height of what the feet of one who sits stand on.
  double reaching = 0.0;    ///< 0 arms hang … 1 both hands at `reachX_m`, `reachZ_m`.
  double reachX_m = anatomy::kReach_m;
  double reachZ_m = 1.02;
  double gesture = 0.0;   ///< 0 … 1 one hand raised in talk.
  double turn_rad = 0.0;  ///< Of the head, to the left.

  [[nodiscard]] bool operator==(const FigurePose& other) const;
};

/// A body in the clothes of its look, x to the front, z up, the origin on the floor under its hips; textured as the
/// namespace outfit says. One who sits has the feet kSeatedFeet_m in front of the hips.
[[nodiscard]] Mesh poseFigure(const Look& look, const FigurePose& pose);

constexpr double kSeatedFeet_m = 0.42;
constexpr float kHipAboveSeat_m = 0.1F;  ///< Of the joint, at girth 1.

}  // namespace wardslam::synth
