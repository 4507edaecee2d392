#include "people/person.h"

#include <algorithm>
#include <cmath>

#include "people/anatomy.h"
#include "textures/textures.h"

namespace wardslam::synth {
namespace {

using namespace anatomy;

Mesh dressed(const Mesh& mesh, const cv::Rect2f& cloth) { return anatomy::dressed(mesh, cloth, 0.006F); }

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

/// From the hem to the neck; the origin is between the hips.
Mesh makeTorso(const Look& look) {
  const float g = look.girth;
  const float hem = look.garment == Garment::Tunic ? -0.15F : -0.06F;
  const float flare = look.garment == Garment::Tunic ? 0.035F : 0.0F;
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
  Mesh hair = cutFree(loft({{0.02F, 0.088F, 0.075F, -0.022F},
                            {0.07F, 0.108F, 0.088F, -0.012F},
                            {0.13F, 0.106F, 0.086F, -0.006F},
                            {0.165F, 0.075F, 0.062F, -0.008F},
                            {0.18F, 0.0F, 0.0F, -0.01F}},
                           16),
                      0.01F);
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

Parts partsOf(const Look& look) {
  const float g = look.girth;
  Parts parts;
  parts.torso = makeTorso(look);
  parts.head = makeHead(look.hair);
  parts.upperArm = dressed(limb(kUpperArm_m, 0.056F * g, 0.045F), outfit::kSleeve);
  parts.forearm = dressed(limb(kForearm_m, 0.042F, 0.03F), outfit::kSkin);
  parts.hand = dressed(ellipsoid({0.04F, 0.024F, 0.085F}, 6, 10), outfit::kSkin);
  parts.thigh = dressed(limb(kThigh_m, 0.092F * g, 0.066F * g), outfit::kTrousers);
  parts.shin = dressed(limb(kShin_m, 0.064F * g, 0.05F), outfit::kTrousers);
  parts.shoe = dressed(makeShoe(0.052F, 0.05F), outfit::kShoes);
  parts.hip_m = 0.09F;
  parts.shoulder_m = 0.205F * (0.9F + 0.1F * g);
  parts.elbowToHand_m = kForearm_m + 0.06F;
  return parts;
}

LimbAngles armAngles(const Posture& posture, double phase_rad) {
  const double swing = -0.4 * posture.swing * std::sin(phase_rad) * (1 - posture.reaching);
  return {swing + 0.62 * posture.reaching,
          0.18 + 0.25 * posture.swing * (1 - posture.reaching) + 0.4 * posture.reaching};
}

}  // namespace

Mesh posePerson(const Look& look, const Posture& posture) {
  Stance stance;
  stance.lean_rad = 0.04 * posture.swing + 0.1 * posture.reaching;
  float hip_m = 0.0F;
  for (const std::size_t side : {kRight, kLeft}) {
    const double phase_rad = phaseOf(side, posture.stride_rad);
    stance.arms[side] = armAngles(posture, phase_rad);
    stance.legs[side] = walkingLeg(posture.swing, phase_rad);
    hip_m = std::max(hip_m, legLength<float>(stance.legs[side]));  // the lower foot touches the floor
  }
  stance.hip_m = static_cast<double>(hip_m);
  return assemble(partsOf(look), stance, look.height_m);
}

}  // namespace wardslam::synth
