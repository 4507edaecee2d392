#include "people/anatomy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace wardslam::synth::anatomy {
namespace {

using Eigen::Vector3f;

Mesh point() {
  Mesh mesh;
  mesh.vertices.resize(1);
  return mesh;
}

/// Where the origins of both, the right one first, come to lie if nothing else is there.
Pair<Vector3f> handsOf(const Stance& stance, float height_m = kReferenceHeight_m) {
  Parts parts;
  parts.hand = point();
  const Mesh body = assemble(parts, stance, height_m);
  return {body.vertices.at(0).p_m, body.vertices.at(1).p_m};
}

Pair<Vector3f> anklesOf(const Stance& stance, float height_m = kReferenceHeight_m) {
  Parts parts;
  parts.shoe = point();
  const Mesh body = assemble(parts, stance, height_m);
  return {body.vertices.at(0).p_m, body.vertices.at(1).p_m};
}

void expectNear(const Vector3f& is, const Vector3f& expected) {
  EXPECT_LT((is - expected).norm(), 1e-5F) << is.transpose() << " instead of " << expected.transpose();
}

TEST(Anatomy, StraightLegsReachTheFloorAndArmsHangBeside) {
  Stance stance;
  stance.hip_m = 0.925;  // 0.43 + 0.42 + 0.075
  EXPECT_NEAR(legLength<double>({}), 0.925, 1e-6);
  expectNear(anklesOf(stance)[kRight], {0, -0.09F, 0.075F});
  expectNear(anklesOf(stance)[kLeft], {0, 0.09F, 0.075F});
  expectNear(handsOf(stance)[kRight], {0, -0.2F, 0.885F});  // 0.925 + 0.5 - 0.29 - 0.25
  expectNear(handsOf(stance)[kLeft], {0, 0.2F, 0.885F});
}

TEST(Anatomy, JointsTurnForwardOneAfterTheOther) {
  Stance stance;
  stance.hip_m = 0.5;
  stance.legs[kLeft] = {M_PI / 2, -M_PI / 2};  // thigh to the front, shin down
  stance.arms[kRight] = {0.0, M_PI / 2};       // upper arm down, forearm to the front
  expectNear(anklesOf(stance)[kLeft], {0.43F, 0.09F, 0.08F});
  expectNear(anklesOf(stance)[kRight], {0, -0.09F, -0.35F});
  expectNear(handsOf(stance)[kRight], {0.25F, -0.2F, 0.71F});
  EXPECT_NEAR(legLength<double>(stance.legs[kLeft]), 0.495, 1e-6);
}

TEST(Anatomy, WhatIsAboveTheHipsLeansForward) {
  Stance stance;
  stance.lean_rad = M_PI / 2;
  stance.arms.fill({-M_PI / 2, 0.0});  // backwards, so up once it leans
  expectNear(handsOf(stance)[kLeft], {0.5F, 0.2F, 0.54F});
  expectNear(anklesOf(stance)[kLeft], {0, 0.09F, -0.85F});
}

TEST(Anatomy, LimbsPartToTheirOwnSide) {
  Stance stance;
  stance.armsAway_rad = static_cast<float>(M_PI / 2);
  stance.legsApart_rad = static_cast<float>(M_PI / 2);
  stance.legs.fill({M_PI / 2, 0.0});
  expectNear(handsOf(stance)[kLeft], {0, 0.74F, 0.5F});
  expectNear(handsOf(stance)[kRight], {0, -0.74F, 0.5F});
  expectNear(anklesOf(stance)[kLeft], {0, 0.94F, 0});
  expectNear(anklesOf(stance)[kRight], {0, -0.94F, 0});
}

TEST(Anatomy, GrowsWithTheHeight) {
  Stance stance;
  stance.hip_m = 0.925;
  expectNear(anklesOf(stance, 0.875F)[kLeft], {0, 0.045F, 0.0375F});
  EXPECT_NEAR(strideLength_m(1.75F), 1.36, 1e-6);
  EXPECT_NEAR(strideLength_m(0.875F), 0.68, 1e-6);
}

TEST(Anatomy, LegsWalkHalfACycleApart) {
  const double stride_rad = 0.4;
  EXPECT_NEAR(phaseOf(kRight, stride_rad) - phaseOf(kLeft, stride_rad), M_PI, 1e-12);
  EXPECT_NEAR(walkingLeg(1.0, M_PI / 2).upper_rad, 0.5, 1e-12);
  EXPECT_NEAR(walkingLeg(0.5, 0.0).bend_rad, -0.315, 1e-12);
  EXPECT_EQ(walkingLeg(0.0, 1.0).upper_rad, 0.0);
}

TEST(Anatomy, HairLeavesTheFaceFree) {
  Mesh hair;
  hair.vertices.resize(2);
  hair.vertices[0].p_m = {0.09F, 0, 0.05F};  // on the cheek
  hair.vertices[1].p_m = {0.09F, 0, 0.15F};  // above the forehead
  const Mesh cut = cutFree(hair, 0.01F);
  EXPECT_FLOAT_EQ(cut.vertices[0].p_m.x(), 0.01F);
  EXPECT_FLOAT_EQ(cut.vertices[1].p_m.x(), 0.09F);
}

TEST(Anatomy, SolesAreFlat) {
  float lowest_m = 0.0F;
  for (const Vertex& vertex : makeShoe(0.05F, 0.05F).vertices) lowest_m = std::min(lowest_m, vertex.p_m.z());
  EXPECT_FLOAT_EQ(lowest_m, -kAnkle_m);
}

}  // namespace
}  // namespace wardslam::synth::anatomy
