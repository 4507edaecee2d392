#include "rendering/shading.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

namespace wardslam::synth {
namespace {

/// Light from above, a little from the front and the right; what turns away has 0.74 of its colour.
const Eigen::Vector3f kLight = Eigen::Vector3f(0.38F, -0.23F, 0.89F).normalized();

/// Two rows of four texels: blue 10, 20, 30, 40 and 110 … 140.
std::map<Material, cv::Mat> texture() {
  cv::Mat image(2, 4, CV_8UC3);
  image.forEach<cv::Vec3b>([](cv::Vec3b& out, const int* at) {
    out = {static_cast<std::uint8_t>(100 * at[0] + 10 * (at[1] + 1)), 50, 200};
  });
  return {{Material::Wood, image}};
}

/// Turned away from the light, so that 0.74 of the colour is left.
Eigen::Array3f colourAt(float u, float v) {
  const std::array<Vertex, 3> corners = {Vertex{{0, 0, 0}, -kLight, {0, 0}}, Vertex{{1, 0, 0}, -kLight, {1, 0}},
                                         Vertex{{0, 1, 0}, -kLight, {0, 1}}};
  const Piece piece{corners.data(), 1, Material::Wood, 1};
  return Shading(texture()).colourOf({&piece, corners.data(), u, v, 1.0F}) / 0.74F;
}

TEST(Shading, ShowsTexelsAtTheirMiddles) {
  EXPECT_NEAR(colourAt(0.125F, 0.25F)[0], 10, 0.6);
  EXPECT_NEAR(colourAt(0.375F, 0.25F)[0], 20, 0.6);
  EXPECT_NEAR(colourAt(0.125F, 0.75F)[0], 110, 0.6);
  EXPECT_NEAR(colourAt(0.125F, 0.25F)[1], 50, 0.6);
  EXPECT_NEAR(colourAt(0.125F, 0.25F)[2], 200, 0.8);
}

TEST(Shading, BlendsNeighbouringTexels) {
  EXPECT_NEAR(colourAt(0.25F, 0.25F)[0], 15, 0.6);
  EXPECT_NEAR(colourAt(0.125F, 0.5F)[0], 60, 0.6);
  EXPECT_NEAR(colourAt(0.25F, 0.5F)[0], 65, 0.6);
}

TEST(Shading, TexturesRepeat) {
  for (const float turns : {-3.0F, -1.0F, 1.0F, 12.0F}) {
    EXPECT_NEAR(colourAt(0.375F + turns, 0.25F)[0], 20, 0.6) << turns;
    EXPECT_NEAR(colourAt(0.375F, 0.25F + turns)[0], 20, 0.6) << turns;
  }
  EXPECT_NEAR(colourAt(0.0F, 0.25F)[0], 25, 0.6) << "between the last texel and the first";
  EXPECT_NEAR(colourAt(0.125F, 0.0F)[0], 60, 0.6);
}

TEST(Shading, LightsWhatFacesTheLight) {
  const Eigen::Vector3f halfway(kLight.z(), 0, -kLight.x());  // at a right angle
  for (const auto& [normal, light] : {std::pair<Eigen::Vector3f, float>(kLight, 1.10F), {halfway, 0.74F}}) {
    const std::array<Vertex, 3> corners = {Vertex{{0, 0, 0}, normal, {0.125F, 0.25F}},
                                           Vertex{{1, 0, 0}, normal, {0.125F, 0.25F}},
                                           Vertex{{0, 1, 0}, normal, {0.125F, 0.25F}}};
    const Piece piece{corners.data(), 1, Material::Wood, 1};
    const Eigen::Array3f colour = Shading(texture()).colourOf({&piece, corners.data(), 0.3F, 0.3F, 1.0F});
    EXPECT_NEAR(colour[1], 50 * light, 1.0);
    EXPECT_NEAR(colour[2], 200 * light, 1.5);
  }
  EXPECT_TRUE((Shading(texture()).colourOf({}) == 0.0F).all()) << "nothing is black";
}

using Spots = std::vector<std::pair<Eigen::AlignedBox2f, float>>;

/// Looking down from 1 m over (x, y) on a white floor.
float floorUnder(const Spots& spots, float x, float y, float depth_m = 1.0F) {
  FloorShadows shadows;
  for (const auto& [area_m, z_m] : spots) shadows.add(area_m, z_m);
  return shadows.over(Eigen::Array3f::Constant(200), {x, y, 1}, {0, 0, -1}, depth_m)[0];
}

TEST(FloorShadows, DarkenTheFloorAroundTheirMiddle) {
  const Spots one = {{{Eigen::Vector2f(-1, -0.5F), Eigen::Vector2f(1, 0.5F)}, 0.01F}};
  constexpr float kBlack = 20 * (0.74F + 0.36F * 0.895F);
  EXPECT_NEAR(floorUnder(one, 0, 0), 200 + 0.89F * (kBlack - 200), 0.5);
  EXPECT_NEAR(floorUnder(one, 0.5F, 0), 200 + 0.89F * 0.5625F * (kBlack - 200), 0.5);  // (1 - 0.25)²
  EXPECT_NEAR(floorUnder(one, 0, 0.25F), floorUnder(one, 0.5F, 0), 0.5);
  EXPECT_EQ(floorUnder(one, 1.1F, 0), 200);
  EXPECT_EQ(floorUnder(one, 0, 0, 0.9F), 200) << "what stands on the floor hides it";
  EXPECT_EQ(floorUnder({}, 0, 0), 200);
}

TEST(FloorShadows, LieUponThoseBefore) {
  const Eigen::AlignedBox2f here(Eigen::Vector2f(-1, -1), Eigen::Vector2f(1, 1));
  const Eigen::AlignedBox2f elsewhere(Eigen::Vector2f(3, 3), Eigen::Vector2f(5, 5));
  const float one = floorUnder({{here, 0.01F}}, 0.5F, 0.5F);
  EXPECT_LT(floorUnder({{here, 0.01F}, {here, 0.02F}}, 0.5F, 0.5F), one - 10);
  EXPECT_EQ(floorUnder({{here, 0.02F}, {here, 0.01F}}, 0.5F, 0.5F), one) << "the lower one is hidden";
  EXPECT_EQ(floorUnder({{elsewhere, 0.02F}, {here, 0.01F}}, 0.5F, 0.5F), one) << "but not by one that lies elsewhere";
}

}  // namespace
}  // namespace wardslam::synth
