#include "textures/textures.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

namespace wardslam::synth {
namespace {

TEST(Textures, TheSeedDecides) {
  const auto one = paintTextures({}, 1);
  const auto again = paintTextures({}, 1);
  const auto other = paintTextures({}, 2);
  for (const auto& [material, texture] : one) {
    EXPECT_EQ(cv::norm(texture, again.at(material), cv::NORM_INF), 0.0);
    EXPECT_GT(cv::norm(texture, other.at(material), cv::NORM_INF), 0.0);
  }
}

TEST(Textures, NoneIsPlain) {
  for (const auto& [material, texture] : paintTextures({}, 1)) {
    ASSERT_EQ(texture.type(), CV_8UC3);
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(texture, mean, deviation);
    EXPECT_GT(deviation[1], 4.0) << static_cast<int>(material);
  }
}

TEST(Textures, FurnitureDarkensTheFloorBelowIt) {
  RoomShape room;
  const auto empty = paintTextures(room, 1).at(Material::Floor);
  room.footprints_m.emplace_back(4.0F, 1.0F, 1.0F, 1.0F);
  const auto shaded = paintTextures(room, 1).at(Material::Floor);
  const double pixels_per_m = shaded.cols / static_cast<double>(room.length_m);
  // The texture's first row lies at y = width.
  const cv::Rect below(cvRound(4.3 * pixels_per_m), cvRound((6.4 - 1.7) * pixels_per_m), 60, 60);
  EXPECT_LT(cv::mean(shaded(below))[0], 0.75 * cv::mean(empty(below))[0]);
  const cv::Rect elsewhere(cvRound(7.0 * pixels_per_m), below.y, 60, 60);
  EXPECT_EQ(cv::norm(shaded(elsewhere), empty(elsewhere), cv::NORM_INF), 0.0);
}

}  // namespace
}  // namespace wardslam::synth
