#pragma once

#include <cstdint>
#include <map>
#include <opencv2/core.hpp>
#include <vector>

namespace wardslam::synth {

/// What a surface is made of; each has one painted texture.
enum class Material {
  Floor,
  Ceiling,
  WallNorth,
  WallSouth,
  WallEast,
  WallWest,
  Wood,
  Metal,
  Plastic,
  Rubber,
  Linen,
  Blanket,
  Curtain,
  ChairFabric,
  Posters,  ///< kPosterColumns × kPosterRows different prints.
  Screens,  ///< Left half: patient monitor, right half: television.
  Leaves,
  OutfitNurse,
  OutfitPorter,
  OutfitVisitor,
  CorridorWall,  ///< Walls within a building; only where RoomShape has them.
  RoomsWall,
  PartitionWest,
  PartitionEast,
  TiledWall,  ///< Only in the hospital, from here on.
  BareWall,   ///< White, and next to nothing on it.
  WindowView,
  DoorLeaf,
  Signs,
  Red,
  OutfitPatient
};

constexpr int kPosterColumns = 4;
constexpr int kPosterRows = 4;

/// Where an outfit texture shows what, in uv.
namespace outfit {
inline const cv::Rect2f kShirt{0.0F, 0.0F, 0.5F, 0.5F};  ///< Around the body, front at u = 0.
inline const cv::Rect2f kTrousers{0.5F, 0.0F, 0.25F, 0.5F};
inline const cv::Rect2f kSleeve{0.75F, 0.0F, 0.25F, 0.5F};
inline const cv::Rect2f kFace{0.0F, 0.5F, 0.5F, 0.5F};  ///< Around the head, face at u = 0.5.
inline const cv::Rect2f kSkin{0.5F, 0.5F, 0.25F, 0.25F};
inline const cv::Rect2f kHair{0.75F, 0.5F, 0.25F, 0.25F};
inline const cv::Rect2f kShoes{0.5F, 0.75F, 0.25F, 0.25F};
}  // namespace outfit

/// The room, or rooms under one ceiling, that the walls, floor and ceiling are painted for, and what throws a soft
/// shadow on the floor.
struct RoomShape {
  float length_m = 9.0F;  ///< Along x.
  float width_m = 6.4F;   ///< Along y.
  float height_m = 2.9F;
  std::vector<cv::Rect2f> footprints_m;
  std::map<Material, float> innerWalls_m;  ///< Length of each.
};

/// Paints all textures (CV_8UC3, BGR). The same seed paints the same bytes.
[[nodiscard]] std::map<Material, cv::Mat> paintTextures(const RoomShape& room, std::uint32_t seed);

}  // namespace wardslam::synth
