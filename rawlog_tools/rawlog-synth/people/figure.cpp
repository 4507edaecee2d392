#include "people/figure.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "people/figure_parts.h"

namespace wardslam::synth {
namespace {

using namespace anatomy;

LimbAngles mix(const LimbAngles& a, const LimbAngles& b, double w) {
  return {(1 - w) * a.upper_rad + w * b.upper_rad, (1 - w) * a.bend_rad + w * b.bend_rad};
}

/// Reaches the point `forward_m` in front of and `down_m` below its root, or towards it where that is too far.
/// `bends`: -1 as a knee does, +1 as an elbow.
LimbAngles reach(double forward_m, double down_m, double upper_m, double lower_m, double bends) {
  const double d =
      std::clamp(std::hypot(forward_m, down_m), std::abs(upper_m - lower_m) + 1e-3, upper_m + lower_m - 1e-6);
  const double inner =
      std::acos(std::clamp((upper_m * upper_m + lower_m * lower_m - d * d) / (2 * upper_m * lower_m), -1.0, 1.0));
  const double root =
      std::acos(std::clamp((upper_m * upper_m + d * d - lower_m * lower_m) / (2 * upper_m * d), -1.0, 1.0));
  return {std::atan2(forward_m, down_m) - bends * root, bends * (M_PI - inner)};
}

LimbAngles armAngles(const FigurePose& pose, std::size_t side, double hip_m, double scale) {
  const double phase = phaseOf(side, pose.stride_rad);
  LimbAngles arm{-0.4 * pose.swing * std::sin(phase) + 0.04, 0.18 + 0.25 * pose.swing};
  arm = mix(arm, {0.16, 1.05}, pose.sitting);  // hands on the thighs
  if (side == kRight) arm = mix(arm, {0.45, 1.55}, pose.gesture);
  const double shoulder_m = hip_m + kShoulderAboveHip_m;
  const LimbAngles held =
      reach(pose.reachX_m / scale - 0.04, shoulder_m - pose.reachZ_m / scale, kUpperArm_m, kForearm_m + 0.08F, 1.0);
  return mix(arm, held, pose.reaching);
}

/// Legs, and how high the hips are over them.
void poseLegs(const FigurePose& pose, const Look& look, double scale, Stance& stance) {
  for (const std::size_t side : {kRight, kLeft})
    stance.legs[side] = walkingLeg(pose.swing, phaseOf(side, pose.stride_rad));
  stance.hip_m = std::max(legLength<double>(stance.legs[kLeft]), legLength<double>(stance.legs[kRight]));
  if (pose.sitting <= 0) return;
  const double seated_m = pose.seat_m / scale + static_cast<double>(kHipAboveSeat_m * look.girth);
  stance.hip_m += pose.sitting * (seated_m - stance.hip_m);
  const double ankle_m = static_cast<double>(kAnkle_m) + pose.sitting * pose.footrest_m / scale;
  const double forward_m = pose.sitting * kSeatedFeet_m / scale;
  // From standing with straight legs on, the feet stay where they are: all of it is inverse kinematics.
  stance.legs.fill(reach(forward_m, stance.hip_m - ankle_m, kThigh_m, kShin_m, -1.0));
  stance.legsApart_rad = 0.1F * static_cast<float>(pose.sitting);
}

Stance stanceOf(const Look& look, const FigurePose& pose) {
  const auto scale = static_cast<double>(look.height_m / kReferenceHeight_m);
  Stance stance;
  poseLegs(pose, look, scale, stance);
  for (const std::size_t side : {kRight, kLeft}) stance.arms[side] = armAngles(pose, side, stance.hip_m, scale);
  stance.armsAway_rad = 0.07F + 0.12F * (look.girth - 1);
  stance.lean_rad = 0.04 * pose.swing + 0.08 * pose.reaching * (1 - pose.sitting) - 0.06 * pose.sitting +
                    1.1 * pose.sitting * (1 - pose.sitting);  // leans forward on the way down and up
  stance.headTurn_rad = pose.turn_rad;
  return stance;
}

}  // namespace

bool FigurePose::operator==(const FigurePose& o) const {
  const auto all = [](const FigurePose& p) {
    return std::tie(p.stride_rad, p.swing, p.sitting, p.seat_m, p.footrest_m, p.reaching, p.reachX_m, p.reachZ_m,
                    p.gesture, p.turn_rad);
  };
  return all(*this) == all(o);
}

Mesh poseFigure(const Look& look, const FigurePose& pose) {
  const Stance stance = stanceOf(look, pose);
  Parts parts = figure::makeParts(look);
  if (look.garment != Garment::Shirt)
    parts.skirt = figure::makeSkirtOfGarment(look, stance.legs[kLeft].upper_rad, stance.legs[kRight].upper_rad);
  return assemble(parts, stance, look.height_m);
}

}  // namespace wardslam::synth
