#include "people/anatomy.h"

#include <algorithm>

namespace wardslam::synth::anatomy {
namespace {

using Eigen::Isometry3f;
using Eigen::Vector3f;

/// A joint at `p` that swings what hangs from it forward by `angle`.
Isometry3f joint(const Vector3f& p, double angle_rad) {
  return Eigen::Translation3f(p) * Eigen::AngleAxisf(-static_cast<float>(angle_rad), Vector3f::UnitY());
}

Mesh makeLeg(const Parts& parts, const LimbAngles& angles) {
  Mesh leg = parts.thigh;
  const Isometry3f knee = joint({0, 0, -kThigh_m}, angles.bend_rad);
  leg.append(Mesh(parts.shin).transform(knee));
  // The foot follows a walking leg a little and stays flat under a seated one.
  const double slope = angles.upper_rad + angles.bend_rad;
  const double flat = std::abs(angles.upper_rad) > 0.7 ? 1.0 : 0.7;
  return leg.append(Mesh(parts.shoe).transform(knee * joint({0, 0, -kShin_m}, -flat * slope)));
}

Mesh makeArm(const Parts& parts, const LimbAngles& angles) {
  Mesh arm = parts.upperArm;
  const Isometry3f elbow = joint({0, 0, -kUpperArm_m}, angles.bend_rad);
  arm.append(Mesh(parts.forearm).transform(elbow));
  return arm.append(Mesh(parts.hand).transform(elbow * Eigen::Translation3f(0.0F, 0.0F, -parts.elbowToHand_m)));
}

float signOf(std::size_t side) { return side == kLeft ? 1.0F : -1.0F; }

}  // namespace

Mesh assemble(const Parts& parts, const Stance& stance, float height_m) {
  Mesh body = parts.torso;
  body.append(Mesh(parts.head).transform(at(0.015F, 0, 0.635F, static_cast<float>(stance.headTurn_rad))));
  for (const std::size_t side : {kRight, kLeft}) {
    const LimbAngles& arm = stance.arms[side];
    const Vector3f shoulder(0, signOf(side) * parts.shoulder_m, kShoulderAboveHip_m - parts.shoulderDrop_m);
    const Isometry3f away =
        Eigen::Translation3f(shoulder) * Eigen::AngleAxisf(signOf(side) * stance.armsAway_rad, Vector3f::UnitX());
    body.append(makeArm(parts, arm).transform(away * joint(Vector3f::Zero(), arm.upper_rad)));
  }
  body.transform(joint(Vector3f::Zero(), -stance.lean_rad));
  body.append(parts.pelvis);
  for (const std::size_t side : {kRight, kLeft}) {
    const LimbAngles& leg = stance.legs[side];
    const Isometry3f hip = at(0, signOf(side) * parts.hip_m, 0, signOf(side) * stance.legsApart_rad);
    body.append(makeLeg(parts, leg).transform(hip * joint(Vector3f::Zero(), leg.upper_rad)));
  }
  body.append(parts.skirt);
  body.transform(at(0, 0, static_cast<float>(stance.hip_m)));
  const float scale = height_m / kReferenceHeight_m;
  for (Vertex& vertex : body.vertices) vertex.p_m *= scale;
  return body;
}

double phaseOf(std::size_t side, double stride_rad) { return stride_rad + (side == kLeft ? 0.0 : M_PI); }

LimbAngles walkingLeg(double swing, double phase_rad) {
  const double knee = 0.55 * std::max(0.0, std::cos(phase_rad)) + 0.08;  // bends while the leg is brought forward
  return {swing * (0.46 * std::sin(phase_rad) + 0.04), -swing * knee};
}

double strideLength_m(float height_m) { return 1.36 * static_cast<double>(height_m / kReferenceHeight_m); }

Mesh dressed(Mesh mesh, const cv::Rect2f& cloth, float rim) {
  return mesh.mapUv({cloth.x + rim, cloth.y + rim}, {cloth.width - 2 * rim, cloth.height - 2 * rim});
}

Mesh makeShoe(float halfWidth_m, float forward_m) {
  Mesh shoe = ellipsoid({0.14F, halfWidth_m, 0.055F}, 6, 12).transform(at(forward_m, 0, -0.03F));
  for (Vertex& vertex : shoe.vertices) vertex.p_m.z() = std::max(vertex.p_m.z(), -kAnkle_m);
  return shoe;
}

Mesh cutFree(Mesh hair, float ahead_m) {
  constexpr float kForehead_m = 0.1F;
  for (Vertex& vertex : hair.vertices) {
    if (vertex.p_m.z() < kForehead_m) vertex.p_m.x() = std::min(vertex.p_m.x(), ahead_m);
  }
  return hair;
}

}  // namespace wardslam::synth::anatomy
