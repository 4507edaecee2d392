#include "people/figure.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "people/figure_parts.h"

namespace wardslam::synth {
namespace {

using Eigen::Isometry3f;
using Eigen::Vector3f;
using namespace figure;

constexpr float kReferenceHeight_m = 1.75F;

/// A joint at `p` that swings what hangs from it forward by `angle`.
Isometry3f joint(const Vector3f& p, double angle_rad) {
  return Eigen::Translation3f(p) * Eigen::AngleAxisf(-static_cast<float>(angle_rad), Vector3f::UnitY());
}

/// Angles of a limb of two parts, upper from the vertical, lower against the upper one.
struct LimbAngles {
  double upper_rad = 0.0;
  double bend_rad = 0.0;
};

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

LimbAngles walkingLeg(const FigurePose& pose, double phase) {
  const double knee = 0.55 * std::max(0.0, std::cos(phase)) + 0.08;  // bends while the leg is brought forward
  return {pose.swing * (0.46 * std::sin(phase) + 0.04), -pose.swing * knee};
}

double legLength(const LimbAngles& leg) {
  return kThigh_m * std::cos(leg.upper_rad) + kShin_m * std::cos(leg.upper_rad + leg.bend_rad) +
         static_cast<double>(kAnkle_m);
}

Mesh makeLeg(const LimbAngles& angles, const Look& look) {
  Mesh leg = makeThigh(look);
  const Isometry3f knee = joint({0, 0, -kThigh_m}, angles.bend_rad);
  leg.append(makeShin(look).transform(knee));
  // The foot follows a walking leg a little and stays flat under a seated one.
  const double slope = angles.upper_rad + angles.bend_rad;
  const double flat = std::abs(angles.upper_rad) > 0.7 ? 1.0 : 0.7;
  return leg.append(makeShoe().transform(knee * joint({0, 0, -kShin_m}, -flat * slope)));
}

Mesh makeArm(const LimbAngles& angles, const Look& look) {
  Mesh arm = makeUpperArm(look);
  const Isometry3f elbow = joint({0, 0, -kUpperArm_m}, angles.bend_rad);
  arm.append(makeForearm(look).transform(elbow));
  return arm.append(makeHand().transform(elbow * Eigen::Translation3f(0.0F, 0.0F, -kForearm_m)));
}

LimbAngles armAngles(const FigurePose& pose, double side, double hip_m, double scale) {
  const double phase = pose.stride_rad + (side > 0 ? 0.0 : M_PI);
  LimbAngles arm{-0.4 * pose.swing * std::sin(phase) + 0.04, 0.18 + 0.25 * pose.swing};
  arm = mix(arm, {0.16, 1.05}, pose.sitting);  // hands on the thighs
  if (side < 0) arm = mix(arm, {0.45, 1.55}, pose.gesture);
  const double shoulder_m = hip_m + kShoulderAboveHip_m;
  const LimbAngles held =
      reach(pose.reachX_m / scale - 0.04, shoulder_m - pose.reachZ_m / scale, kUpperArm_m, kForearm_m + 0.08F, 1.0);
  return mix(arm, held, pose.reaching);
}

struct Legs {
  LimbAngles left;
  LimbAngles right;
  double hip_m = 0.0;
};

Legs poseLegs(const FigurePose& pose, const Look& look, double scale) {
  Legs legs{walkingLeg(pose, pose.stride_rad), walkingLeg(pose, pose.stride_rad + M_PI), 0.0};
  legs.hip_m = std::max(legLength(legs.left), legLength(legs.right));
  if (pose.sitting <= 0) return legs;
  const double seated_m = pose.seat_m / scale + static_cast<double>(kHipAboveSeat_m * look.girth);
  legs.hip_m += pose.sitting * (seated_m - legs.hip_m);
  const double ankle_m = static_cast<double>(kAnkle_m) + pose.sitting * pose.footrest_m / scale;
  const double forward_m = pose.sitting * kSeatedFeet_m / scale;
  // From standing with straight legs on, the feet stay where they are: all of it is inverse kinematics.
  legs.left = legs.right = reach(forward_m, legs.hip_m - ankle_m, kThigh_m, kShin_m, -1.0);
  return legs;
}

}  // namespace

bool FigurePose::operator==(const FigurePose& o) const {
  const auto all = [](const FigurePose& p) {
    return std::tie(p.stride_rad, p.swing, p.sitting, p.seat_m, p.footrest_m, p.reaching, p.reachX_m, p.reachZ_m,
                    p.gesture, p.turn_rad);
  };
  return all(*this) == all(o);
}

double strideLength_m(const Look& look) { return 1.36 * static_cast<double>(look.height_m / kReferenceHeight_m); }

Mesh poseFigure(const Look& look, const FigurePose& pose) {
  const float scale = look.height_m / kReferenceHeight_m;
  const Legs legs = poseLegs(pose, look, static_cast<double>(scale));
  Mesh person = makeTorso(look);
  person.append(makeHead(look).transform(at(0.015F, 0, 0.635F, static_cast<float>(pose.turn_rad))));
  for (const float side : {-1.0F, 1.0F}) {
    const LimbAngles arm = armAngles(pose, static_cast<double>(side), legs.hip_m, static_cast<double>(scale));
    const Vector3f shoulder(0, side * shoulderOffset_m(look), kShoulderAboveHip_m - 0.01F);
    // Upper arms hang a little away from the body.
    const Isometry3f away = Eigen::Translation3f(shoulder) *
                            Eigen::AngleAxisf(side * (0.07F + 0.12F * (look.girth - 1)), Vector3f::UnitX());
    person.append(makeArm(arm, look).transform(away * joint(Vector3f::Zero(), arm.upper_rad)));
  }
  const double lean = 0.04 * pose.swing + 0.08 * pose.reaching * (1 - pose.sitting) - 0.06 * pose.sitting +
                      1.1 * pose.sitting * (1 - pose.sitting);  // leans forward on the way down and up
  person.transform(joint(Vector3f::Zero(), -lean));
  person.append(makePelvis(look));
  for (const float side : {-1.0F, 1.0F}) {
    const float spread = side * 0.1F * static_cast<float>(pose.sitting);
    const Isometry3f hip = at(0, side * kHipOffset_m * (0.8F + 0.2F * look.girth), 0, spread);
    const LimbAngles& leg = side > 0 ? legs.left : legs.right;
    person.append(makeLeg(leg, look).transform(hip * joint(Vector3f::Zero(), leg.upper_rad)));
  }
  if (look.garment != Garment::Shirt)
    person.append(makeSkirtOfGarment(look, legs.left.upper_rad, legs.right.upper_rad));
  person.transform(at(0, 0, static_cast<float>(legs.hip_m)));
  for (Vertex& vertex : person.vertices) vertex.p_m *= scale;
  return person;
}

}  // namespace wardslam::synth
