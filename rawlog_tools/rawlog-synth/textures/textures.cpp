#include "textures/textures.h"

#include "textures/texture_painters.h"

namespace wardslam::synth {
namespace {

const OutfitColours kNurse{{168, 142, 42},  {150, 124, 36}, {235, 235, 235},
                           {158, 186, 226}, {38, 52, 84},   OutfitColours::Pattern::Scrubs};
const OutfitColours kPorter{{150, 84, 40},  {62, 52, 48}, {40, 40, 42},
                            {92, 128, 178}, {26, 26, 30}, OutfitColours::Pattern::Polo};
const OutfitColours kVisitor{{70, 92, 196},   {128, 88, 58},  {70, 84, 110},
                             {168, 194, 232}, {96, 150, 196}, OutfitColours::Pattern::Striped};

}  // namespace

std::map<Material, cv::Mat> paintTextures(const RoomShape& room, std::uint32_t seed) {
  std::map<Material, cv::Mat> textures;
  // Each texture has its own numbers: changing one painter leaves the others as they are.
  const auto paint = [&](Material material, auto painter) {
    cv::RNG rng((static_cast<std::uint64_t>(seed) << 32) + static_cast<std::uint64_t>(material) + 1);
    textures.emplace(material, painter(rng));
  };
  const cv::Scalar green(196, 208, 184);
  const cv::Scalar blue(214, 200, 176);
  const auto wall = [&](float length_m, WallFeature feature, const cv::Scalar& lower) {
    return [=, &room](cv::RNG& rng) { return paintWall(length_m, room.height_m, feature, lower, rng); };
  };
  paint(Material::Floor, [&](cv::RNG& rng) { return paintFloor(room, rng); });
  paint(Material::Ceiling, [&](cv::RNG& rng) { return paintCeiling(room, rng); });
  paint(Material::WallNorth, wall(room.length_m, WallFeature::None, green));
  paint(Material::WallSouth, wall(room.length_m, WallFeature::None, green));
  paint(Material::WallEast, wall(room.width_m, WallFeature::Window, blue));
  paint(Material::WallWest, wall(room.width_m, WallFeature::Door, blue));
  paint(Material::Wood, paintWood);
  paint(Material::Metal, paintMetal);
  paint(Material::Plastic, paintPlastic);
  paint(Material::Rubber, paintRubber);
  paint(Material::Linen, paintLinen);
  paint(Material::Blanket, paintBlanket);
  paint(Material::Curtain, paintCurtain);
  paint(Material::ChairFabric, paintChairFabric);
  paint(Material::Posters, paintPosters);
  paint(Material::Screens, paintScreens);
  paint(Material::Leaves, paintLeaves);
  paint(Material::OutfitNurse, [](cv::RNG& rng) { return paintOutfit(kNurse, rng); });
  paint(Material::OutfitPorter, [](cv::RNG& rng) { return paintOutfit(kPorter, rng); });
  paint(Material::OutfitVisitor, [](cv::RNG& rng) { return paintOutfit(kVisitor, rng); });
  for (const auto& [material, length_m] : room.innerWalls_m) {
    paint(material, wall(length_m, WallFeature::None, material == Material::CorridorWall ? blue : green));
  }
  return textures;
}

}  // namespace wardslam::synth
