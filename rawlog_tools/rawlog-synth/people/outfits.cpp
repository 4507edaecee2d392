#include "people/outfits.h"

#include <array>
#include <iterator>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "textures/texture_painters.h"

namespace wardslam::synth {
namespace {

constexpr int kTexture_px = 384;
constexpr int kFirstMaterial = 1000;

using Pattern = OutfitColours::Pattern;

// Colours are BGR.
const std::array<cv::Scalar, 5> kSkins = {
    {{178, 202, 238}, {158, 186, 226}, {118, 154, 204}, {82, 116, 168}, {52, 74, 112}}};
const std::array<cv::Scalar, 6> kHairs = {
    {{38, 52, 84}, {24, 24, 28}, {96, 150, 196}, {150, 152, 156}, {44, 70, 122}, {206, 208, 212}}};
const cv::Scalar kWhite(236, 238, 238);
const cv::Scalar kBlack(38, 36, 36);

struct Suit {
  Role role;
  Pattern pattern;
  cv::Scalar shirt;
  cv::Scalar trousers;
};

const std::vector<Suit>& suits() {
  static const std::vector<Suit> kSuits = {{Role::Nurse, Pattern::Scrubs, {168, 142, 42}, {150, 124, 36}},
                                           {Role::Nurse, Pattern::Plain, {120, 62, 34}, {110, 56, 30}},
                                           {Role::Nurse, Pattern::Polo, {230, 232, 232}, {224, 226, 226}},
                                           {Role::Nurse, Pattern::Plain, {84, 44, 124}, {88, 48, 126}},
                                           {Role::Nurse, Pattern::Scrubs, {150, 170, 96}, {226, 228, 226}},
                                           {Role::Doctor, Pattern::Coat, {238, 240, 240}, {70, 62, 58}},
                                           {Role::Doctor, Pattern::Coat, {234, 238, 240}, {120, 90, 52}},
                                           {Role::Doctor, Pattern::Plain, {110, 132, 52}, {106, 128, 50}},
                                           {Role::Doctor, Pattern::Coat, {232, 234, 238}, {110, 140, 162}},
                                           {Role::Porter, Pattern::Polo, {150, 84, 40}, {62, 52, 48}},
                                           {Role::Porter, Pattern::Polo, {60, 140, 70}, {70, 66, 64}},
                                           {Role::Porter, Pattern::Polo, {62, 62, 66}, {116, 78, 46}},
                                           {Role::Visitor, Pattern::Striped, {70, 92, 196}, {128, 88, 58}},
                                           {Role::Visitor, Pattern::Plain, {52, 46, 150}, {60, 52, 50}},
                                           {Role::Visitor, Pattern::Checked, {170, 128, 82}, {112, 78, 50}},
                                           {Role::Visitor, Pattern::Plain, {58, 58, 62}, {132, 96, 62}},
                                           {Role::Visitor, Pattern::Plain, {84, 168, 214}, {84, 76, 72}},
                                           {Role::Visitor, Pattern::Striped, {222, 226, 228}, {72, 52, 40}},
                                           {Role::Visitor, Pattern::Checked, {92, 150, 96}, {112, 132, 156}},
                                           {Role::Visitor, Pattern::Plain, {150, 132, 178}, {46, 44, 46}},
                                           {Role::Patient, Pattern::Gown, {220, 202, 172}, {214, 198, 170}},
                                           {Role::Patient, Pattern::Gown, {206, 216, 190}, {206, 214, 190}},
                                           {Role::Patient, Pattern::Plain, {178, 154, 124}, {172, 148, 118}}};
  return kSuits;
}

/// Two people of each suit, who differ in skin and hair.
constexpr std::size_t kPeoplePerSuit = 2;

}  // namespace

Material lifeOutfit(std::size_t number) { return static_cast<Material>(kFirstMaterial + static_cast<int>(number)); }

std::size_t lifeOutfitCount() { return kPeoplePerSuit * suits().size(); }

cv::Mat paintLifeOutfit(Material outfit, std::uint32_t seed) {
  const auto number = static_cast<std::size_t>(static_cast<int>(outfit) - kFirstMaterial);
  cv::RNG rng((static_cast<std::uint64_t>(seed) << 32U) + kFirstMaterial + number);
  const Suit& suit = suits()[number / kPeoplePerSuit];
  const auto pick = [&](const auto& choices) {
    return choices[static_cast<std::size_t>(rng.uniform(0, static_cast<int>(std::size(choices))))];
  };
  OutfitColours colours;
  colours.pattern = suit.pattern;
  colours.shirt = suit.shirt;
  colours.trousers = suit.trousers;
  colours.shoes = rng.uniform(0, 2) == 0 ? kWhite : kBlack;
  colours.skin = pick(kSkins);
  colours.hair = pick(kHairs);
  cv::Mat small;
  cv::resize(paintOutfit(colours, rng), small, {kTexture_px, kTexture_px}, 0, 0, cv::INTER_AREA);
  return small;
}

Look randomLook(Role role, cv::RNG& rng) {
  std::vector<std::size_t> fitting;
  for (std::size_t i = 0; i < lifeOutfitCount(); ++i) {
    if (suits()[i / kPeoplePerSuit].role == role) fitting.push_back(i);
  }
  const std::size_t chosen = fitting[static_cast<std::size_t>(rng.uniform(0, static_cast<int>(fitting.size())))];
  Look look;
  look.outfit = lifeOutfit(chosen);
  look.height_m = std::min(1.96F, std::max(1.5F, 1.72F + 0.09F * static_cast<float>(rng.gaussian(1.0))));
  look.girth = std::min(1.4F, std::max(0.92F, 1.08F + 0.12F * static_cast<float>(rng.gaussian(1.0))));
  look.hair = static_cast<HairStyle>(rng.uniform(0, 3));
  look.bald = look.hair == HairStyle::Short && rng.uniform(0, 5) == 0;
  const Pattern pattern = suits()[chosen / kPeoplePerSuit].pattern;
  if (role == Role::Nurse) look.garment = rng.uniform(0, 3) == 0 ? Garment::Shirt : Garment::Tunic;
  if (pattern == Pattern::Coat) look.garment = Garment::Coat;
  if (pattern == Pattern::Gown) look.garment = Garment::Gown;
  look.longSleeves = pattern == Pattern::Coat || (role == Role::Visitor && rng.uniform(0, 2) == 0);
  return look;
}

}  // namespace wardslam::synth
