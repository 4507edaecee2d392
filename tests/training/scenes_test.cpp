#include "scenes.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <set>

#include "soft_things.h"

namespace wardslam::training {
namespace {

TEST(Scenes, DependOnTheirSeedAlone) {
  const Scenes once(40, 12, 1), again(40, 12, 3), later(41, 11, 2);
  EXPECT_EQ(once.primitives, again.primitives);
  EXPECT_EQ(once.counts, again.counts);
  EXPECT_EQ(once.cameras, again.cameras);
  for (int s = 0; s < later.count(); ++s) EXPECT_EQ(later.counts[std::size_t(s)], once.counts[std::size_t(s) + 1]) << s;
  EXPECT_NE(std::vector<float>(once.camera(0), once.camera(1)), std::vector<float>(once.camera(1), once.camera(2)));
}

TEST(Scenes, HoldPrimitivesThatCanBeCast) {
  const Scenes scenes(1000, 300);
  EXPECT_EQ(scenes.overran, 0);
  for (int s = 0; s < scenes.count(); ++s) {
    EXPECT_GT(scenes.counts[std::size_t(s)], 5) << "scene " << s;
    for (int k = 0; k < scenes.counts[std::size_t(s)]; ++k) {
      const float* p = scenes.primitive(s, k);
      for (int f = 0; f < kFloats; ++f)
        ASSERT_TRUE(std::isfinite(p[f])) << "scene " << s << ", primitive " << k << ", float " << f;
      ASSERT_THAT(p[0], ::testing::AllOf(::testing::Ge(0.F), ::testing::Le(float(kSheet))));
      ASSERT_THAT(p[1], ::testing::AllOf(::testing::Ge(0.F), ::testing::Lt(float(kClasses))));
      ASSERT_THAT(p[2], ::testing::AllOf(::testing::Ge(0.F), ::testing::Le(250.F)));
      ASSERT_THAT(p[3], ::testing::AllOf(::testing::Ge(0.F), ::testing::Le(1.F)));
      ASSERT_GT(p[7], 0.F) << "a bounding sphere without a radius";
    }
  }
}

TEST(Scenes, HaveEveryClassAndPeopleInMostOfThem) {
  const Scenes scenes(5000, 300);
  std::array<int, kClasses> with{};
  for (int s = 0; s < scenes.count(); ++s) {
    std::set<int> classes;
    for (int k = 0; k < scenes.counts[std::size_t(s)]; ++k) classes.insert(int(scenes.primitive(s, k)[1]));
    for (const int c : classes) ++with[std::size_t(c)];
  }
  for (int c = 0; c < kClasses; ++c)
    EXPECT_GE(with[std::size_t(c)], 12) << "class " << c << " in " << with[std::size_t(c)] << " of 300 scenes";
  EXPECT_THAT(with[kPerson], ::testing::AllOf(::testing::Gt(150), ::testing::Lt(285)));
}

TEST(Scenes, AreLookedAtByUprightCamerasInTheRoom) {
  const Scenes scenes(9000, 200);
  for (int s = 0; s < scenes.count(); ++s) {
    const float* c = scenes.camera(s);
    const auto column = [&](int k) { return V3{c[k], c[3 + k], c[6 + k]}; };
    const V3 x = column(0), y = column(1), z = column(2);
    EXPECT_NEAR(dot(x, x), 1, 1e-5);
    EXPECT_NEAR(dot(x, y), 0, 1e-5);
    EXPECT_NEAR(dot(cross(x, y), z), 1, 1e-5) << "no right-handed rotation";
    EXPECT_LT(y.z, 0.F) << "scene " << s << " is upside down";
    EXPECT_THAT(c[11], ::testing::AllOf(::testing::Gt(0.F), ::testing::Lt(5.5F))) << "height";
    EXPECT_THAT(c[12], ::testing::AllOf(::testing::Ge(420.F), ::testing::Le(640.F))) << "focal length";
    EXPECT_NEAR(c[14], 319.5, 40);
    EXPECT_NEAR(c[15], 239.5, 40);
  }
}

TEST(Scenes, AreSeenWithPeopleAndMostlyBackground) {
  const Scenes scenes(20000, 96);
  const Images images(scenes.primitives, scenes.counts, kCapacity, scenes.cameras, 64, 48);
  std::array<double, kClasses> share{};
  std::size_t hit = 0;
  for (std::size_t k = 0; k < images.cls.size(); ++k) {
    share[images.cls[k]] += 1.0 / double(images.cls.size());
    hit += images.depth_m[k] > 0;
    // Small plants among what lies about have none.
    if (images.cls[k] != kBackground && images.cls[k] != kPlant)
      ASSERT_GT(images.instance[k], 0) << "a thing without an instance";
    if (images.depth_m[k] <= 0) EXPECT_EQ(images.cls[k], kBackground);
  }
  EXPECT_GT(double(hit) / double(images.cls.size()), 0.9);
  EXPECT_THAT(share[kPerson], ::testing::AllOf(::testing::Gt(0.03), ::testing::Lt(0.25)));
  EXPECT_THAT(share[kBackground], ::testing::AllOf(::testing::Gt(0.5), ::testing::Lt(0.9)));
}

TEST(SoftThings, KeepTheirClassAndStayWhereTheyArePut) {
  Random random{7};
  for (int k = 0; k < 200; ++k) {
    std::vector<float> primitives;
    Builder b{random, primitives, Pose{}};
    softThing(b, {1, 2, 0.7F}, 0.3F);
    ASSERT_FALSE(primitives.empty());
    for (std::size_t p = 0; p < primitives.size(); p += kFloats) {
      EXPECT_EQ(primitives[p + 1], float(kBackground));
      const V3 centre{primitives[p + 4], primitives[p + 5], primitives[p + 6]};
      EXPECT_LT(length(centre - V3{1, 2, 0.7F}), 0.9F);
    }
  }
}

}  // namespace
}  // namespace wardslam::training
