#include "people/person.h"

#include <algorithm>
#include <cmath>

#include "textures/textures.h"

namespace wardslam::synth {
namespace {

using Eigen::Isometry3f;
using Eigen::Vector3f;

// Lengths of a person of kReferenceHeight_m.
constexpr float kReferenceHeight_m = 1.75F;
constexpr float kThigh_m = 0.43F;
constexpr float kShin_m = 0.42F;
constexpr float kAnkle_m = 0.075F;
constexpr float kHipWidth_m = 0.09F;
constexpr float kShoulderWidth_m = 0.205F;
constexpr float kShoulderAboveHip_m = 0.5F;
constexpr float kUpperArm_m = 0.29F;
constexpr float kForearm_m = 0.25F;

Mesh dressed(Mesh mesh, const cv::Rect2f& cloth) {
  // A small inset keeps interpolation from drawing in the neighbour's colour.
  constexpr float kInset = 0.006F;
  return mesh.mapUv({cloth.x + kInset, cloth.y + kInset}, {cloth.width - 2 * kInset, cloth.height - 2 * kInset});
}

/// A joint at `p` that swings what hangs from it forward by `angle`.
Isometry3f joint(const Vector3f& p, double angle_rad) {
  return Eigen::Translation3f(p) * Eigen::AngleAxisf(-static_cast<float>(angle_rad), Vector3f::UnitY());
}

/// Limb hanging down from its joint at the origin.
Mesh limb(float length, float top, float bottom) {
  return loft({{-length - 0.4F * bottom, 0, 0},
               {-length - 0.3F * bottom, 0.7F * bottom, 0.7F * bottom},
               {-length, bottom, bottom},
               {-0.6F * length, 0.45F * top + 0.6F * bottom, 0.45F * top + 0.6F * bottom},
               {-0.2F * length, top, top},
               {0.02F, 0.95F * top, 0.95F * top},
               {0.6F * top, 0.6F * top, 0.6F * top},
               {0.8F * top, 0, 0}},
              12);
}

Mesh makeShoe() {
  Mesh shoe = ellipsoid({0.14F, 0.052F, 0.055F}, 6, 12).transform(at(0.05F, 0, -0.03F));
  for (Vertex& vertex : shoe.vertices) vertex.p_m.z() = std::max(vertex.p_m.z(), -kAnkle_m);  // flat sole
  return shoe;
}

struct LegAngles {
  double hip_rad;
  double knee_rad;
};

LegAngles legAngles(const Posture& posture, double phase) {
  const double knee = 0.55 * std::max(0.0, std::cos(phase)) + 0.08;  // bends while the leg is brought forward
  return {posture.swing * (0.46 * std::sin(phase) + 0.04), posture.swing * knee};
}

/// Height of the hip above the sole for these angles.
float legLength(const LegAngles& angles) {
  return kThigh_m * static_cast<float>(std::cos(angles.hip_rad)) +
         kShin_m * static_cast<float>(std::cos(angles.hip_rad - angles.knee_rad)) + kAnkle_m;
}

Mesh makeLeg(const LegAngles& angles, float girth) {
  Mesh leg = dressed(limb(kThigh_m, 0.092F * girth, 0.066F * girth), outfit::kTrousers);
  const Isometry3f knee = joint({0, 0, -kThigh_m}, -angles.knee_rad);
  leg.append(dressed(limb(kShin_m, 0.064F * girth, 0.05F), outfit::kTrousers).transform(knee));
  const Isometry3f ankle = knee * joint({0, 0, -kShin_m}, -0.7 * (angles.hip_rad - angles.knee_rad));
  return leg.append(dressed(makeShoe(), outfit::kShoes).transform(ankle));
}

Mesh makeArm(double elbow_rad, float girth) {
  Mesh arm = dressed(limb(kUpperArm_m, 0.056F * girth, 0.045F), outfit::kSleeve);
  const Isometry3f elbow = joint({0, 0, -kUpperArm_m}, elbow_rad);
  arm.append(dressed(limb(kForearm_m, 0.042F, 0.03F), outfit::kSkin).transform(elbow));
  const Isometry3f hand = elbow * Eigen::Translation3f(0.0F, 0.0F, -kForearm_m - 0.06F);
  return arm.append(dressed(ellipsoid({0.04F, 0.024F, 0.085F}, 6, 10), outfit::kSkin).transform(hand));
}

/// From the hem to the neck; the origin is between the hips.
Mesh makeTorso(const Body& body) {
  const float g = body.girth;
  const float hem = body.clothing == Clothing::Tunic ? -0.15F : -0.06F;
  const float flare = body.clothing == Clothing::Tunic ? 0.035F : 0.0F;
  return dressed(loft({{hem, 0.02F, 0.02F},
                       {hem + 0.005F, 0.125F * g + flare, 0.178F * g + flare},
                       {0.06F, 0.128F * g, 0.175F * g},
                       {0.2F, 0.112F * g, 0.152F * g, 0.005F},
                       {0.36F, 0.128F * g, 0.182F, 0.012F},
                       {0.46F, 0.115F, 0.2F, 0.005F},
                       {0.53F, 0.085F, 0.17F},
                       {0.565F, 0.062F, 0.085F},
                       {0.6F, 0.052F, 0.054F, 0.005F}},
                      20),
                 outfit::kShirt);
}

Mesh makeHair(HairStyle style) {
  Mesh hair = loft({{0.02F, 0.088F, 0.075F, -0.022F},
                    {0.07F, 0.108F, 0.088F, -0.012F},
                    {0.13F, 0.106F, 0.086F, -0.006F},
                    {0.165F, 0.075F, 0.062F, -0.008F},
                    {0.18F, 0.0F, 0.0F, -0.01F}},
                   16);
  // Cut free from the forehead down: what would cover the face is pushed to the back of it.
  for (Vertex& vertex : hair.vertices) {
    if (vertex.p_m.z() < 0.1F) vertex.p_m.x() = std::min(vertex.p_m.x(), 0.01F);
  }
  if (style == HairStyle::Bun) hair.append(ellipsoid({0.05F, 0.055F, 0.05F}).transform(at(-0.13F, 0, 0.1F)));
  if (style == HairStyle::Long) hair.append(ellipsoid({0.05F, 0.085F, 0.16F}).transform(at(-0.075F, 0, -0.03F)));
  return hair;
}

/// The origin is the top of the neck.
Mesh makeHead(HairStyle style) {
  Mesh skull = loft({{-0.045F, 0.0F, 0.0F, -0.035F},
                     {-0.04F, 0.035F, 0.032F, -0.035F},
                     {0.0F, 0.078F, 0.058F, -0.016F},
                     {0.05F, 0.096F, 0.072F, -0.002F},
                     {0.1F, 0.099F, 0.077F},
                     {0.14F, 0.085F, 0.068F},
                     {0.165F, 0.05F, 0.042F},
                     {0.175F, 0.0F, 0.0F}},
                    18);
  // The face is painted around u = 0.5, which a loft has at its back: turn it round.
  Mesh head = dressed(skull, outfit::kFace).transform(at(0, 0, 0, static_cast<float>(M_PI)));
  head.append(dressed(ellipsoid({0.022F, 0.014F, 0.026F}, 6, 8), outfit::kSkin).transform(at(0.1F, 0, 0.055F)));
  for (const float side : {-1.0F, 1.0F}) {
    head.append(dressed(ellipsoid({0.016F, 0.01F, 0.03F}, 6, 8), outfit::kSkin).transform(at(0, side * 0.077F, 0.06F)));
  }
  head.append(dressed(limb(0.09F, 0.05F, 0.053F), outfit::kSkin).transform(at(0.0F, 0, 0.02F)));
  return head.append(dressed(makeHair(style), outfit::kHair));
}

}  // namespace

double strideLength_m(const Body& body) { return 1.36 * static_cast<double>(body.height_m / kReferenceHeight_m); }

Mesh posePerson(const Body& body, const Posture& posture) {
  Mesh person = makeTorso(body);
  const double lean = 0.04 * posture.swing + 0.1 * posture.reaching;
  person.append(makeHead(body.hair).transform(at(0.015F, 0, 0.635F)));
  for (const float side : {-1.0F, 1.0F}) {
    const double phase = posture.stride_rad + (side > 0 ? 0.0 : M_PI);
    const double swing = -0.4 * posture.swing * std::sin(phase) * (1 - posture.reaching);
    const double shoulder = swing + 0.62 * posture.reaching;
    const double elbow = 0.18 + 0.25 * posture.swing * (1 - posture.reaching) + 0.4 * posture.reaching;
    const Isometry3f T =
        joint({0, side * kShoulderWidth_m * (0.9F + 0.1F * body.girth), kShoulderAboveHip_m}, shoulder);
    person.append(makeArm(elbow, body.girth).transform(T));
  }
  person.transform(joint(Vector3f::Zero(), -lean));

  float hipHeight = 0.0F;
  for (const float side : {-1.0F, 1.0F}) {
    const LegAngles angles = legAngles(posture, posture.stride_rad + (side > 0 ? 0.0 : M_PI));
    hipHeight = std::max(hipHeight, legLength(angles));
    person.append(makeLeg(angles, body.girth).transform(joint({0, side * kHipWidth_m, 0}, angles.hip_rad)));
  }
  person.transform(at(0, 0, hipHeight));  // the lower foot touches the floor
  for (Vertex& vertex : person.vertices) vertex.p_m *= body.height_m / kReferenceHeight_m;
  return person;
}

}  // namespace wardslam::synth
