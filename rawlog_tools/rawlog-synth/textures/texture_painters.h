#pragma once

#include <opencv2/core.hpp>

#include "textures/textures.h"

/// One painter per texture; used by paintTextures() only.
namespace wardslam::synth {

[[nodiscard]] cv::Mat paintFloor(const RoomShape& room, cv::RNG& rng);
[[nodiscard]] cv::Mat paintCeiling(const RoomShape& room, cv::RNG& rng);

enum class WallFeature { None, Window, Door };
[[nodiscard]] cv::Mat paintWall(float length_m, float height_m, WallFeature feature, const cv::Scalar& lowerColour,
                                cv::RNG& rng);

[[nodiscard]] cv::Mat paintWood(cv::RNG& rng);
[[nodiscard]] cv::Mat paintMetal(cv::RNG& rng);
[[nodiscard]] cv::Mat paintPlastic(cv::RNG& rng);
[[nodiscard]] cv::Mat paintRubber(cv::RNG& rng);
[[nodiscard]] cv::Mat paintLinen(cv::RNG& rng);
[[nodiscard]] cv::Mat paintBlanket(cv::RNG& rng);
[[nodiscard]] cv::Mat paintCurtain(cv::RNG& rng);
[[nodiscard]] cv::Mat paintChairFabric(cv::RNG& rng);
[[nodiscard]] cv::Mat paintPosters(cv::RNG& rng);
[[nodiscard]] cv::Mat paintScreens(cv::RNG& rng);
[[nodiscard]] cv::Mat paintLeaves(cv::RNG& rng);

struct OutfitColours {
  cv::Scalar shirt;
  cv::Scalar trousers;
  cv::Scalar shoes;
  cv::Scalar skin;
  cv::Scalar hair;
  enum class Pattern { Scrubs, Polo, Striped, Plain, Coat, Gown, Checked } pattern;
};
[[nodiscard]] cv::Mat paintOutfit(const OutfitColours& colours, cv::RNG& rng);

}  // namespace wardslam::synth
