// Depth and labels of single primitives against worked-out values.
#include <gmock/gmock.h>

#include <cmath>

#include "scene.h"
#include "scenes.h"

namespace wardslam::training {
namespace {

constexpr float kFocal_px = 500;

/// A camera at the world's origin that looks along +x, world z up: x right = -y, y down = -z, z forward = x.
std::vector<float> cameraAtOrigin() {
  return {0, 0, 1, -1, 0, 0, 0, -1, 0, 0, 0, 0, kFocal_px, kFocal_px, 319.5F, 239.5F};
}

struct Stage {
  Random random{1};
  std::vector<float> primitives;
  Builder builder{random, primitives, Pose{}};

  Stage() { builder.cls = kBed, builder.instance = 9, builder.loss = 0.5F; }
  [[nodiscard]] Images seen() const {
    const int count = int(primitives.size()) / kPrimitiveFloats;
    return Images(primitives, {count}, count, cameraAtOrigin(), 640, 480);
  }
};

TEST(RayCaster, SeesABoxWhereItsFaceIs) {
  Stage stage;
  stage.builder.box({3, 0, 0}, {0.5F, 0.4F, 0.3F});
  const Images images = stage.seen();
  EXPECT_NEAR(images.depth_m[images.at(320, 240)], 2.5, 1e-5);
  EXPECT_EQ(images.cls[images.at(320, 240)], kBed);
  EXPECT_EQ(images.instance[images.at(320, 240)], 9);
  EXPECT_EQ(images.material[images.at(320, 240)], 127);
  // The face's edge at y = -0.4 is 0.4 / 2.5 * 500 = 80 px to the right of 319.5.
  EXPECT_NEAR(images.depth_m[images.at(399, 240)], 2.5, 1e-5);
  EXPECT_EQ(images.depth_m[images.at(400, 240)], 0);
  EXPECT_EQ(images.cls[images.at(400, 240)], kBackground);
  EXPECT_NEAR(images.depth_m[images.at(320, 299)], 2.5, 1e-5);
  EXPECT_EQ(images.depth_m[images.at(320, 300)], 0);
}

TEST(RayCaster, SeesRoundThingsWhereTheyAre) {
  // Along the ray through pixel (320, 240), half a pixel off the axis in both directions: all within 1e-5 of the axis'
  // depth.
  const auto depth = [](auto build) {
    Stage stage;
    build(stage.builder);
    const Images images = stage.seen();
    return images.depth_m[images.at(320, 240)];
  };
  EXPECT_NEAR(depth([](Builder& b) { b.ellipsoid({2, 0, 0}, {0.25F, 0.5F, 1}); }), 1.75, 1e-4);
  EXPECT_NEAR(depth([](Builder& b) { b.cylinder({2, 0, -1}, {2, 0, 1}, 0.3F); }), 1.7, 1e-4);
  EXPECT_NEAR(depth([](Builder& b) { b.capsule({2, 0, -1}, {2, 0, 1}, 0.1F); }), 1.9, 1e-4);
  EXPECT_NEAR(depth([](Builder& b) { b.roundedBox({2, 0, 0}, {0.2F, 0.2F, 0.2F}, 0.1F); }), 1.8, 1e-3);
  // A cone of radius 0.1 below and 0.3 above, 0.2 in the middle; its side leans by 0.2 over 2 m.
  EXPECT_NEAR(depth([](Builder& b) { b.frustum({2, 0, -1}, {2, 0, 1}, 0.1F, 0.3F); }), 1.8, 1e-3);
  EXPECT_NEAR(depth([](Builder& b) { b.sheet({2, 0, 0}, 1, 1, 0, 1, 0, 0, 1, Rz(kPi / 2)); }), 2.0, 2e-3);
}

TEST(RayCaster, LooksThroughARing) {
  Stage stage;
  stage.builder.annulus({2, 0, 0}, {1, 0, 0}, 0.2F, 0.3F);
  stage.builder.cls = kCurtain, stage.builder.instance = 3;
  stage.builder.box({4, 0, 0}, {0.5F, 5, 5});
  const Images images = stage.seen();
  EXPECT_EQ(images.cls[images.at(320, 240)], kCurtain);  // 3.5 m, through the hole
  EXPECT_NEAR(images.depth_m[images.at(320, 240)], 3.5, 1e-5);
  EXPECT_EQ(images.cls[images.at(320 + 62, 240)], kBed);  // 62 px: 0.25 m from the ring's centre
  EXPECT_NEAR(images.depth_m[images.at(320 + 62, 240)], 2, 1e-5);
  EXPECT_EQ(images.instance[images.at(320 + 80, 240)], 3);  // 0.32 m: beside it
}

TEST(RayCaster, TakesWhatIsNearest) {
  Stage stage;
  stage.builder.box({4, 0, 0}, {0.1F, 1, 1});
  stage.builder.cls = kPerson;
  stage.builder.ellipsoid({2, 0, 0}, {0.2F, 0.2F, 0.2F});
  stage.builder.cls = kTable;
  stage.builder.box({6, 0, 0}, {0.1F, 3, 3});
  const Images images = stage.seen();
  EXPECT_EQ(images.cls[images.at(320, 240)], kPerson);
  EXPECT_EQ(images.cls[images.at(390, 240)], kBed);
  EXPECT_EQ(images.cls[images.at(500, 240)], kTable);
}

TEST(RayCaster, SeesTheSameAtEverySize) {
  Stage stage;
  stage.builder.box({3, 0.2F, 0.1F}, {0.5F, 2, 2}, Rz(0.5F));
  const int count = int(stage.primitives.size()) / kPrimitiveFloats;
  const Images full(stage.primitives, {count}, count, cameraAtOrigin(), 640, 480),
      half(stage.primitives, {count}, count, cameraAtOrigin(), 320, 240);
  // A small pixel's centre lies between four of the large image, over which 1 / depth is linear.
  const float mean = 0.25F * (1 / full.depth_m[full.at(200, 100)] + 1 / full.depth_m[full.at(201, 100)] +
                              1 / full.depth_m[full.at(200, 101)] + 1 / full.depth_m[full.at(201, 101)]);
  EXPECT_NEAR(1 / half.depth_m[half.at(100, 50)], mean, 1e-6);
}

}  // namespace
}  // namespace wardslam::training
