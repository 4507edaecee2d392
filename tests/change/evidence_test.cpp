#include "evidence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace wardslam::change {
namespace {

core::CameraModel camera() {
  core::CameraModel camera;
  camera.width_px = 320;
  camera.height_px = 240;
  camera.fx_px = camera.fy_px = 260.0;
  camera.cx_px = 160.0;
  camera.cy_px = 120.0;
  return camera;
}

Seen wallSeen(double wall_m, double z_m) { return seenAt(z_m, {wall_m, wall_m}, {}, {}); }

TEST(PixelOf, IsWhereTheCameraShowsAPointThatIsNotTooNear) {
  const auto px = pixelOf({0.5, -0.25, 2.0}, camera());
  ASSERT_TRUE(px);
  EXPECT_DOUBLE_EQ(px->x(), 160.0 + 260.0 * 0.25);
  EXPECT_DOUBLE_EQ(px->y(), 120.0 - 260.0 * 0.125);
  EXPECT_TRUE(pixelOf({0, 0, 0.3}, camera()));
  EXPECT_FALSE(pixelOf({0, 0, 0.29}, camera()));
  EXPECT_FALSE(pixelOf({0, 0, -2.0}, camera())) << "behind it";
}

TEST(SeenAt, TakesDifferencesWithinTheNoiseForTheSameSurface) {
  const double sigma_m = core::DepthNoise().sigma_m(3.0);
  const double limit_m = 0.04 + 4.0 * std::sqrt(2.0) * sigma_m;  // at nearly the same depth in both
  EXPECT_EQ(wallSeen(3.0, 3.0), Seen::Same);
  EXPECT_EQ(wallSeen(3.0, 3.0 - 0.9 * limit_m), Seen::Same);
  EXPECT_EQ(wallSeen(3.0, 3.0 - 1.1 * limit_m), Seen::Through);
  EXPECT_EQ(wallSeen(3.0, 3.0 + 0.9 * limit_m), Seen::Same);
  EXPECT_EQ(wallSeen(3.0, 3.0 + 1.2 * limit_m), Seen::Unknown) << "hidden behind it";
}

TEST(SeenAt, AsksTheNoiseOfBothSensors) {
  const core::DepthNoise sharp{0.0, 0.0, 0.0};
  const auto seen = [&](const core::DepthNoise& ofPoint, const core::DepthNoise& ofImage) {
    return seenAt(2.95, {3.0, 3.0}, ofPoint, ofImage);
  };
  EXPECT_EQ(seen(sharp, sharp), Seen::Through) << "5 cm, of which 4 are forgiven";
  EXPECT_EQ(seen({}, sharp), Seen::Same);
  EXPECT_EQ(seen(sharp, {}), Seen::Same);
}

TEST(SeenAt, AtAnEdgeEitherSideMayBeMeant) {
  const DepthRange edge{1.5, 3.0};
  EXPECT_EQ(seenAt(1.0, edge, {}, {}), Seen::Through);
  for (const double z_m : {1.5, 2.2, 3.0}) EXPECT_EQ(seenAt(z_m, edge, {}, {}), Seen::Same) << z_m;
  EXPECT_EQ(seenAt(4.0, edge, {}, {}), Seen::Unknown);
}

TEST(SurfaceTally, NeedsEnoughPointsThatTell) {
  SurfaceTally tally;
  for (int i = 0; i < 100; ++i) tally.add(Seen::Unknown);
  for (int i = 0; i < 11; ++i) tally.add(Seen::Same);
  for (int i = 0; i < 3; ++i) tally.add(Seen::Through);
  EXPECT_FALSE(tally.changed()) << "fourteen";
  tally.add(Seen::Through);
  EXPECT_DOUBLE_EQ(tally.changed().value(), 4.0 / 15.0);
}

TEST(EvidenceOfSurface, RestCountsTheLongerItLastsAndMotionAtOnce) {
  EXPECT_DOUBLE_EQ(evidenceOfSurface(0.0, 0.1, 1.0), -4.0);
  EXPECT_DOUBLE_EQ(evidenceOfSurface(0.1, 0.1, 0.25), -1.0) << "all of it noise";
  EXPECT_DOUBLE_EQ(evidenceOfSurface(0.2, 0.1, 0.25), 1.2);
  EXPECT_DOUBLE_EQ(evidenceOfSurface(1.0, 0.1, 0.25), 4.0) << "bounded";
}

TEST(EvidenceOfError, IsALikelihoodRatioWithinBounds) {
  EXPECT_DOUBLE_EQ(evidenceOfError(11.0, 10.0, 1.0), 0.25);
  EXPECT_DOUBLE_EQ(evidenceOfError(std::numeric_limits<double>::infinity(), 10.0, 1.0), 1.5);
  EXPECT_DOUBLE_EQ(evidenceOfError(9.0, 10.0, 1.0), -0.25);
  EXPECT_DOUBLE_EQ(evidenceOfError(0.0, 10.0, 1.0), -0.5);
  EXPECT_DOUBLE_EQ(evidenceOfError(0.0, 10.0, 0.4), -0.2) << "a short time tells little about rest";
}

TEST(Combined, SeenMovingOnceIsMoving) {
  EXPECT_EQ(combined(0.0, -0.3), -0.3);
  EXPECT_EQ(combined(-0.3, -0.1), -0.3);
  EXPECT_EQ(combined(-0.3, 0.1), 0.1);
  EXPECT_EQ(combined(0.1, -0.3), 0.1);
  EXPECT_EQ(combined(0.1, 0.4), 0.4);
}

TEST(Updated, FadesAndStaysWithinBounds) {
  EXPECT_DOUBLE_EQ(updated(2.0, 0.5, 0.25), 1.25);
  EXPECT_DOUBLE_EQ(updated(-2.0, 0.95, 0.0), -1.9);
  EXPECT_DOUBLE_EQ(updated(3.9, 1.0, 1.5), 4.0);
  EXPECT_DOUBLE_EQ(updated(-3.9, 1.0, -1.5), -4.0);
}

TEST(ProbabilityOf, IsTheLogisticFunction) {
  EXPECT_DOUBLE_EQ(probabilityOf(0.0), 0.5);
  EXPECT_NEAR(probabilityOf(std::log(4.0)), 0.8, 1e-12);
}

}  // namespace
}  // namespace wardslam::change
