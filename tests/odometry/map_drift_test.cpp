#include "map_drift.h"

#include <gtest/gtest.h>

namespace wardslam::odometry {
namespace {

/// So far ahead along the optical axis.
Eigen::Isometry3d ahead(double metres) { return Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, metres)); }

/// Variances of the place (along each axis) and the direction (about each).
PoseCovariance variances(double place_m2, double direction_rad2) {
  PoseCovariance covariance = PoseCovariance::Zero();
  covariance.diagonal() << place_m2, place_m2, place_m2, direction_rad2, direction_rad2, direction_rad2;
  return covariance;
}

const PoseCovariance kPlaceAlone = variances(1e-6, 0.0);

TEST(MapDrift, IsNothingWhereThePieceBegins) {
  MapDrift drift(0);
  EXPECT_TRUE(drift.at(Eigen::Isometry3d::Identity()).isZero()) << "before anything";
  drift.begin(1);
  EXPECT_TRUE(drift.at(ahead(1.0)).isZero());
}

TEST(MapDrift, EveryKeyframeAddsTwiceItsOwnCovariance) {
  MapDrift drift(0);
  drift.begin(1);
  for (const KeyframeId id : {2U, 3U, 4U}) drift.add(id, ahead(0.5), kPlaceAlone);
  EXPECT_TRUE(drift.at(Eigen::Isometry3d::Identity()).isApprox(variances(6e-6, 0.0)));
}

/// One of 0.01 rad, a metre ahead, is one of 0.01 m across, and none along.
TEST(MapDrift, ErrorsOfDirectionGrowWithTheWay) {
  MapDrift drift(0);
  drift.begin(1);
  drift.add(2, ahead(1.0), variances(0.0, 0.5e-4));
  const PoseCovariance there = drift.at(ahead(1.0));
  EXPECT_NEAR(there(0, 0), 1e-4, 1e-12);
  EXPECT_NEAR(there(1, 1), 1e-4, 1e-12);
  EXPECT_NEAR(there(2, 2), 0.0, 1e-12);
  EXPECT_NEAR(there(4, 4), 1e-4, 1e-12);
  EXPECT_NEAR(drift.at(ahead(3.0))(0, 0), 9e-4, 1e-12) << "three metres ahead";
  drift.add(3, ahead(2.0), PoseCovariance::Zero());
  EXPECT_NEAR(drift.at(ahead(0.0))(0, 0), 4e-4, 1e-12) << "the next keyframe, two metres on";
  drift.seeAgain({1, 2, ahead(0.0)}, true);  // which is no better than it was
  EXPECT_NEAR(drift.at(ahead(0.0))(0, 0), 4e-4, 1e-12);
}

TEST(MapDrift, WhoSeesAPlaceAgainIsAsSureAsHeWasThere) {
  MapDrift drift(0);
  drift.begin(1);
  for (KeyframeId id = 2; id <= 10; ++id) drift.add(id, ahead(0.1), kPlaceAlone);
  drift.seeAgain({3, 8, ahead(0.0)}, false);  // two keyframes' drift there, and what the eighth adds
  EXPECT_TRUE(drift.at(Eigen::Isometry3d::Identity()).isApprox(variances((4 + 2 + 2 * 2) * 1e-6, 0.0)))
      << "and of the two since";
}

TEST(MapDrift, AnUnsurePlaceMakesNobodyLessSure) {
  MapDrift drift(0);
  drift.begin(1);
  for (KeyframeId id = 2; id <= 4; ++id) drift.add(id, ahead(0.1), kPlaceAlone);
  drift.begin(5);  // a piece of its own
  drift.add(6, ahead(0.1), kPlaceAlone);
  const PlaceSeenAgain place{4, 6, ahead(0.0)};
  drift.seeAgain(place, false);
  EXPECT_TRUE(drift.at(Eigen::Isometry3d::Identity()).isApprox(variances(2e-6, 0.0))) << "in its own frame";
  drift.seeAgain(place, true);
  EXPECT_TRUE(drift.at(Eigen::Isometry3d::Identity()).isApprox(variances(8e-6, 0.0))) << "in that of the older";
}

TEST(MapDrift, TheMapOfAnEarlierRunIsExact) {
  MapDrift drift(100);
  drift.begin(101);
  for (KeyframeId id = 102; id <= 104; ++id) drift.add(id, ahead(0.1), kPlaceAlone);
  drift.seeAgain({42, 104, ahead(0.2)}, true);
  EXPECT_TRUE(drift.at(Eigen::Isometry3d::Identity()).isApprox(variances(2e-6, 0.0)));
}

TEST(MapDrift, OfWhatItDoesNotRememberItSaysNothing) {
  MapDrift drift(0);
  drift.begin(1);
  for (KeyframeId id = 2; id <= 5000; ++id) drift.add(id, ahead(0.1), kPlaceAlone);
  const PoseCovariance before = drift.at(Eigen::Isometry3d::Identity());
  EXPECT_NEAR(before(0, 0), 4999 * 2e-6, 1e-9);
  drift.seeAgain({2, 5000, ahead(0.0)}, true);
  drift.seeAgain({4990, 6000, ahead(0.0)}, true);
  EXPECT_EQ(drift.at(Eigen::Isometry3d::Identity()), before);
}

}  // namespace
}  // namespace wardslam::odometry
