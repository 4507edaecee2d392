#include "people/person.h"

#include <gtest/gtest.h>

#include <cmath>

#include "people/anatomy.h"

namespace wardslam::synth {
namespace {

Eigen::AlignedBox3f boundsOf(const Mesh& mesh) {
  Eigen::AlignedBox3f box;
  for (const Vertex& vertex : mesh.vertices) box.extend(vertex.p_m);
  return box;
}

TEST(Person, StandsOnTheFloorAtItsHeight) {
  for (const float height_m : {1.5F, 1.75F, 1.95F}) {
    Look look;
    look.height_m = height_m;
    const Eigen::AlignedBox3f box = boundsOf(posePerson(look, {}));
    EXPECT_NEAR(box.min().z(), 0.0F, 0.02F);
    EXPECT_NEAR(box.max().z(), height_m, 0.05F);
  }
}

TEST(Person, KeepsAFootOnTheFloorWhileWalking) {
  for (double phase = 0; phase < 2 * M_PI; phase += 0.2) {
    const Eigen::AlignedBox3f box = boundsOf(posePerson({}, {phase, 1.0, 0.0}));
    EXPECT_NEAR(box.min().z(), 0.0F, 0.06F) << phase;
    EXPECT_GT(box.sizes().x(), 0.3F);
    EXPECT_LT(box.sizes().x(), 1.4F);
  }
}

TEST(Person, StridesFartherThanItStands) {
  const float standing_m = boundsOf(posePerson({}, {M_PI / 2, 0.0, 0.0})).sizes().x();
  const float striding_m = boundsOf(posePerson({}, {M_PI / 2, 1.0, 0.0})).sizes().x();
  EXPECT_GT(striding_m, standing_m + 0.3F);
}

TEST(Person, ReachesForAHandle) {
  const Eigen::AlignedBox3f box = boundsOf(posePerson({}, {0.0, 0.0, 1.0}));
  EXPECT_NEAR(box.max().x(), anatomy::kReach_m, 0.15F);
}

TEST(Person, UsesTheWholeOutfitAndNoMore) {
  for (const HairStyle hair : {HairStyle::Short, HairStyle::Bun, HairStyle::Long}) {
    Look look;
    look.hair = hair;
    for (const Vertex& vertex : posePerson(look, {0.7, 1.0, 0.0}).vertices) {
      EXPECT_GE(vertex.uv.minCoeff(), 0.0F);
      EXPECT_LE(vertex.uv.maxCoeff(), 1.0F);
    }
  }
}

}  // namespace
}  // namespace wardslam::synth
