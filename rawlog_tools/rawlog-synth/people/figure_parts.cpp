#include "people/figure_parts.h"

#include <algorithm>
#include <cmath>

#include "textures/textures.h"

namespace wardslam::synth::figure {
namespace {

using namespace anatomy;

Mesh dressed(const Mesh& mesh, const cv::Rect2f& cloth) { return anatomy::dressed(mesh, cloth, 0.008F); }

/// Limb hanging down from its joint at the origin, with its bulk at `bulk` (0 top … 1 bottom).
Mesh limb(float length, float top, float middle, float bottom, float bulk = 0.35F) {
  return loft({{-length - 0.4F * bottom, 0, 0},
               {-length - 0.3F * bottom, 0.7F * bottom, 0.7F * bottom},
               {-length, bottom, bottom},
               {-(0.5F + 0.5F * bulk) * length, (bottom + middle) / 2, (bottom + middle) / 2},
               {-bulk * length, middle, middle},
               {0.02F, top, top},
               {0.6F * top, 0.6F * top, 0.6F * top},
               {0.8F * top, 0, 0}},
              12);
}

bool bareShins(const Look& look) { return look.garment == Garment::Gown; }

float hemOf(Garment garment) {
  switch (garment) {
    case Garment::Tunic:
      return -0.16F;
    case Garment::Coat:
      return -0.4F;
    case Garment::Gown:
      return -0.5F;
    case Garment::Shirt:
      break;
  }
  return -0.05F;
}

Mesh makeHair(HairStyle style) {
  Mesh hair = cutFree(loft({{0.02F, 0.088F, 0.078F, -0.022F},
                            {0.07F, 0.108F, 0.09F, -0.012F},
                            {0.13F, 0.108F, 0.088F, -0.006F},
                            {0.17F, 0.075F, 0.062F, -0.008F},
                            {0.186F, 0.0F, 0.0F, -0.01F}},
                           18),
                      0.012F);
  if (style == HairStyle::Bun) hair.append(ellipsoid({0.05F, 0.055F, 0.05F}).transform(at(-0.13F, 0, 0.1F)));
  if (style == HairStyle::Long) hair.append(ellipsoid({0.05F, 0.09F, 0.17F}).transform(at(-0.07F, 0, -0.03F)));
  return hair;
}

Mesh makeThigh(const Look& look) {
  const float g = look.girth;
  return dressed(limb(kThigh_m, 0.088F * g, 0.09F * g, 0.066F * g), outfit::kTrousers);
}

Mesh makeShin(const Look& look) {
  const float g = 0.5F + 0.5F * look.girth;
  if (bareShins(look)) return dressed(limb(kShin_m, 0.056F * g, 0.06F * g, 0.04F), outfit::kSkin);
  return dressed(limb(kShin_m, 0.066F * g, 0.068F * g, 0.058F * g), outfit::kTrousers);
}

Mesh makeUpperArm(const Look& look) {
  const float g = 0.3F + 0.7F * look.girth;
  return dressed(limb(kUpperArm_m, 0.062F * g, 0.056F * g, 0.045F * g, 0.3F), outfit::kSleeve);
}

Mesh makeForearm(const Look& look) {
  const float g = 0.5F + 0.5F * look.girth;
  if (look.longSleeves) return dressed(limb(kForearm_m, 0.047F * g, 0.046F * g, 0.037F * g), outfit::kSleeve);
  return dressed(limb(kForearm_m, 0.042F * g, 0.042F * g, 0.028F), outfit::kSkin);
}

Mesh makeHand() {
  Mesh hand = ellipsoid({0.036F, 0.02F, 0.062F}, 6, 10).transform(at(0, 0, -0.06F));
  for (const float x : {-0.02F, 0.0F, 0.02F})
    hand.append(rod({x, 0, -0.1F}, {x + 0.004F, 0, -0.165F}, 0.011F, 0.009F, 6));
  hand.append(rod({0.03F, 0, -0.04F}, {0.055F, 0, -0.1F}, 0.013F, 0.01F, 6));
  return dressed(hand, outfit::kSkin);
}

Mesh makePelvis(const Look& look) {
  const float g = look.girth;
  return dressed(loft({{-0.12F, 0.02F, 0.03F},
                       {-0.11F, 0.08F * g, 0.11F * g},
                       {-0.03F, 0.115F * g, 0.168F * g, -0.005F},
                       {0.05F, 0.115F * g, 0.165F * g},
                       {0.12F, 0.08F * g, 0.12F * g}},
                      20),
                 outfit::kTrousers);
}

Mesh makeTorso(const Look& look) {
  const float g = look.girth;
  const float belly = 0.05F * std::max(0.0F, g - 1.0F);
  return dressed(loft({{-0.06F, 0.08F * g, 0.12F * g},
                       {-0.05F, 0.126F * g, 0.176F * g},
                       {0.06F, 0.126F * g, 0.168F * g, belly},
                       {0.18F, 0.112F * g, 0.15F * g, 0.005F + belly},
                       {0.32F, 0.12F * (0.4F + 0.6F * g), 0.172F * (0.5F + 0.5F * g), 0.012F},
                       {0.42F, 0.115F * (0.5F + 0.5F * g), 0.192F * (0.7F + 0.3F * g), 0.006F},
                       {0.49F, 0.095F, 0.196F * (0.8F + 0.2F * g)},
                       {0.53F, 0.078F, 0.155F},
                       {0.565F, 0.06F, 0.088F},
                       {0.6F, 0.052F, 0.055F, 0.005F}},
                      22),
                 outfit::kShirt);
}

Mesh makeHead(const Look& look) {
  Mesh skull = loft({{-0.055F, 0.0F, 0.0F, -0.045F},
                     {-0.05F, 0.03F, 0.028F, -0.045F},
                     {-0.02F, 0.066F, 0.05F, -0.026F},
                     {0.01F, 0.085F, 0.063F, -0.012F},
                     {0.06F, 0.098F, 0.075F, -0.002F},
                     {0.11F, 0.101F, 0.079F},
                     {0.145F, 0.085F, 0.068F},
                     {0.168F, 0.05F, 0.042F},
                     {0.18F, 0.0F, 0.0F}},
                    20);
  // The face is painted around u = 0.5, which a loft has at its back: turn it round.
  Mesh head = dressed(skull, outfit::kFace).transform(at(0, 0, 0, static_cast<float>(M_PI)));
  head.append(dressed(ellipsoid({0.024F, 0.014F, 0.026F}, 6, 8), outfit::kSkin).transform(at(0.1F, 0, 0.05F)));
  for (const float side : {-1.0F, 1.0F})
    head.append(
        dressed(ellipsoid({0.018F, 0.01F, 0.032F}, 6, 8), outfit::kSkin).transform(at(0, side * 0.079F, 0.06F)));
  head.append(dressed(limb(0.1F, 0.05F, 0.05F, 0.06F), outfit::kSkin).transform(at(-0.01F, 0, 0.02F)));
  if (look.bald) return head;
  return head.append(dressed(makeHair(look.hair), outfit::kHair));
}

}  // namespace

Parts makeParts(const Look& look) {
  Parts parts;
  parts.torso = makeTorso(look);
  parts.head = makeHead(look);
  parts.upperArm = makeUpperArm(look);
  parts.forearm = makeForearm(look);
  parts.hand = makeHand();
  parts.pelvis = makePelvis(look);
  parts.thigh = makeThigh(look);
  parts.shin = makeShin(look);
  parts.shoe = dressed(makeShoe(0.05F, 0.055F), outfit::kShoes);
  parts.hip_m = 0.088F * (0.8F + 0.2F * look.girth);
  parts.shoulder_m = 0.196F * (0.88F + 0.12F * look.girth);
  parts.shoulderDrop_m = 0.01F;
  return parts;
}

Mesh makeSkirtOfGarment(const Look& look, double left_rad, double right_rad) {
  const float hem = hemOf(look.garment);
  const float g = look.girth;
  constexpr int kRings = 5;
  std::vector<Ring> rings;
  for (int i = 0; i <= kRings; ++i) {
    const float w = static_cast<float>(i) / kRings;  // 0 at the hem
    const float flare = 0.05F * (1 - w);
    rings.push_back({hem + w * (0.1F - hem), 0.13F * g + flare, 0.18F * g + 0.6F * flare});
  }
  Mesh skirt = dressed(loft(rings, 22), {outfit::kShirt.x, outfit::kShirt.y, outfit::kShirt.width, 0.12F});
  // Below the hips the cloth follows the thigh of its side.
  for (Vertex& vertex : skirt.vertices) {
    const float below = -std::min(0.0F, vertex.p_m.z());
    const float toLeft = std::clamp(0.5F + vertex.p_m.y() / 0.2F, 0.0F, 1.0F);
    const float angle = toLeft * static_cast<float>(left_rad) + (1 - toLeft) * static_cast<float>(right_rad);
    const float part = std::min(1.0F, below / 0.08F) * angle;
    const Eigen::AngleAxisf turn(-part, Eigen::Vector3f::UnitY());
    vertex.p_m = turn * vertex.p_m;
    vertex.normal = turn * vertex.normal;
  }
  return skirt;
}

}  // namespace wardslam::synth::figure
