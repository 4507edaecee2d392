#include "people/figure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "people/outfits.h"

namespace wardslam::synth {
namespace {

Eigen::AlignedBox3f boxOf(const Mesh& mesh) {
  Eigen::AlignedBox3f box;
  for (const Vertex& vertex : mesh.vertices) box.extend(vertex.p_m);
  return box;
}

/// The lowest of what is within 0.12 m of the origin on the floor plan: what one sits on.
float lowestAtHips(const Mesh& mesh) {
  float lowest = 10.0F;
  for (const Vertex& vertex : mesh.vertices) {
    if (vertex.p_m.head<2>().norm() < 0.12F) lowest = std::min(lowest, vertex.p_m.z());
  }
  return lowest;
}

TEST(Figure, StandsOnTheFloorAtItsHeight) {
  for (const float height_m : {1.5F, 1.75F, 1.95F}) {
    Look look;
    look.height_m = height_m;
    const Eigen::AlignedBox3f box = boxOf(poseFigure(look, {}));
    EXPECT_NEAR(box.min().z(), 0.0F, 0.02F);
    EXPECT_NEAR(box.max().z(), height_m, 0.06F);
  }
}

TEST(Figure, SitsWithItsHipsOnTheSeatAndItsFeetOnTheFloor) {
  for (const float height_m : {1.55F, 1.75F, 1.9F}) {
    for (const double seat_m : {0.44, 0.5}) {
      Look look;
      look.height_m = height_m;
      FigurePose pose;
      pose.sitting = 1.0;
      pose.seat_m = seat_m;
      const Mesh mesh = poseFigure(look, pose);
      EXPECT_NEAR(boxOf(mesh).min().z(), 0.0F, 0.03F) << height_m;
      EXPECT_NEAR(lowestAtHips(mesh), seat_m, 0.05) << height_m;
      // Who sits reaches 0.52 of their height above the seat (anthropometric tables).
      EXPECT_NEAR(boxOf(mesh).max().z(), seat_m + 0.525 * static_cast<double>(height_m), 0.05);
    }
  }
}

TEST(Figure, KeepsItsFeetInPlaceWhileSittingDown) {
  for (double sitting = 0.0; sitting <= 1.0; sitting += 0.1) {
    FigurePose pose;
    pose.sitting = sitting;
    const Mesh mesh = poseFigure({}, pose);
    float toes = -10.0F;  // of the soles only
    for (const Vertex& vertex : mesh.vertices) {
      if (vertex.p_m.z() < 0.05F) toes = std::max(toes, vertex.p_m.x());
    }
    EXPECT_NEAR(toes - static_cast<float>(sitting * kSeatedFeet_m), 0.19F, 0.05F) << sitting;
    EXPECT_NEAR(boxOf(mesh).min().z(), 0.0F, 0.03F) << sitting;
  }
}

TEST(Figure, PutsItsHandsWhereItReaches) {
  FigurePose pose;
  pose.reaching = 1.0;
  pose.reachX_m = 0.5;
  for (const double z_m : {0.9, 1.1}) {
    pose.reachZ_m = z_m;
    float farthest = 0.0F;
    float height = 0.0F;
    for (const Vertex& vertex : poseFigure({}, pose).vertices) {
      if (vertex.p_m.x() <= farthest) continue;
      farthest = vertex.p_m.x();
      height = vertex.p_m.z();
    }
    EXPECT_NEAR(farthest, 0.5, 0.16);
    EXPECT_NEAR(height, z_m, 0.12);
  }
}

TEST(Figure, LooksDifferFromOneAnother) {
  cv::RNG rng(3);
  Look first = randomLook(Role::Visitor, rng);
  bool otherHeight = false;
  bool otherClothes = false;
  for (int i = 0; i < 20; ++i) {
    const Look look = randomLook(Role::Visitor, rng);
    otherHeight = otherHeight || std::abs(look.height_m - first.height_m) > 0.05F;
    otherClothes = otherClothes || look.outfit != first.outfit;
    EXPECT_GE(look.height_m, 1.5F);
    EXPECT_LE(look.height_m, 1.96F);
  }
  EXPECT_TRUE(otherHeight);
  EXPECT_TRUE(otherClothes);
}

}  // namespace
}  // namespace wardslam::synth
