#include "local_map.h"

#include <gmock/gmock.h>

namespace wardslam::odometry {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class LocalMapTest : public ::testing::Test {
 protected:
  static MapPoint pointAt(double x_m, std::uint64_t lastSeenFrame = 0) {
    MapPoint point;
    point.p_map_m = {x_m, 0, 2};
    point.lastSeenFrame = lastSeenFrame;
    return point;
  }

  static LocalMapOptions options() {
    LocalMapOptions options;
    options.max_points = 4;
    options.min_found_ratio = 0.25;
    options.max_fused = 3;
    options.max_neighbours = 2;
    return options;
  }

  static core::Keypoint straightAhead(float z_m) {
    core::Keypoint keypoint;
    keypoint.undistorted_px = {319.5F, 239.5F};
    keypoint.depth_m = z_m;
    return keypoint;
  }

  /// Seen again from the origin, at depth `z_m`.
  void observe(PointId id, float z_m, std::uint64_t frame = 1) {
    map_.observe(id, straightAhead(z_m), {}, Eigen::Isometry3d::Identity(), frame);
  }

  [[nodiscard]] std::vector<PointId> ids() const {
    std::vector<PointId> ids;
    for (const auto& [id, point] : map_.points()) ids.push_back(id);
    return ids;
  }

  LocalMap map_{options()};
};

TEST_F(LocalMapTest, DropsPointsThatAreRarelyFoundWhereTheyShouldBe) {
  const PointId good = map_.add(pointAt(0));
  const PointId poor = map_.add(pointAt(1));
  for (int i = 0; i < 3; ++i) map_.countVisible(poor);  // found once, visible four times: just a quarter
  map_.cull();
  EXPECT_THAT(ids(), ElementsAre(good, poor));
  map_.countVisible(poor);
  map_.cull();
  EXPECT_THAT(ids(), ElementsAre(good));
  EXPECT_EQ(map_.find(poor), nullptr);
}

TEST_F(LocalMapTest, AboveTheLimitForgetsThoseUnseenForLongest) {
  const PointId a = map_.add(pointAt(0, 5));
  const PointId b = map_.add(pointAt(1, 2));
  const PointId c = map_.add(pointAt(2, 9));
  const PointId d = map_.add(pointAt(3, 3));
  const PointId e = map_.add(pointAt(4, 7));
  const PointId f = map_.add(pointAt(5, 4));
  observe(b, 2.0F, 8);
  map_.cull();
  EXPECT_THAT(ids(), ElementsAre(a, b, c, e)) << d << " and " << f << " were seen in frames 3 and 4";
}

TEST_F(LocalMapTest, MeasurementsRefineAPointUntilThereAreEnough) {
  const PointId point =
      map_.add(makeMapPoint(straightAhead(2.0F), OrbDescriptor{}, core::CameraModel{}, Eigen::Isometry3d::Identity()));
  observe(point, 2.02F);
  EXPECT_NEAR(map_.find(point)->p_map_m.z(), 2.01, 1e-3) << "of two measurements";
  observe(point, 2.04F);
  EXPECT_NEAR(map_.find(point)->p_map_m.z(), 2.02, 1e-3) << "of three";
  const double fused_m = map_.find(point)->p_map_m.z();
  observe(point, 3.0F);
  EXPECT_EQ(map_.find(point)->p_map_m.z(), fused_m);
  EXPECT_EQ(map_.find(point)->timesFound, 4);
}

TEST_F(LocalMapTest, AKeypointWithoutDepthOnlyCounts) {
  const PointId id = map_.add(pointAt(0));
  observe(id, 0.0F, 6);
  EXPECT_TRUE(map_.find(id)->p_map_m.isApprox(Eigen::Vector3d(0, 0, 2)));
  EXPECT_EQ(map_.find(id)->timesFound, 2);
  EXPECT_EQ(map_.find(id)->lastSeenFrame, 6U);
}

TEST_F(LocalMapTest, TheNeighbourhoodIsWhatKeyframesSawTogether) {
  std::vector<PointId> p;
  for (int i = 0; i < 7; ++i) p.push_back(map_.add(pointAt(i)));
  map_.addKeyframe(1, {p[0], p[1], p[2]});
  map_.addKeyframe(2, {p[2], p[3]});
  map_.addKeyframe(3, {p[4], p[5]});
  EXPECT_THAT(map_.neighbourhood({p[0]}), ElementsAre(p[0], p[1], p[2]));
  EXPECT_THAT(map_.neighbourhood({p[2]}), ElementsAre(p[0], p[1], p[2], p[3]));
  EXPECT_THAT(map_.neighbourhood({p[6]}), IsEmpty()) << "no keyframe saw it";
  EXPECT_THAT(map_.neighbourhood({}), IsEmpty());
  // Three keyframes have a share, two may: those with most of the seeds.
  EXPECT_THAT(map_.neighbourhood({p[0], p[1], p[4], p[5], p[3]}), ElementsAre(p[0], p[1], p[2], p[4], p[5]));
}

TEST_F(LocalMapTest, TakesOverBetterPositionsAndRemovals) {
  const PointId moved = map_.add(pointAt(0));
  const PointId removed = map_.add(pointAt(1));
  map_.addKeyframe(1, {moved, removed});
  MapUpdate update;
  update.p_map_m[moved] = {0.5, 0, 2};
  update.p_map_m[999] = {1, 1, 1};  // forgotten meanwhile
  update.removedPoints = {removed, 998};
  map_.apply(update, 7);
  EXPECT_THAT(ids(), ElementsAre(moved));
  EXPECT_TRUE(map_.find(moved)->p_map_m.isApprox(Eigen::Vector3d(0.5, 0, 2)));
  EXPECT_THAT(map_.neighbourhood({moved}), ElementsAre(moved));
}

TEST_F(LocalMapTest, TakesOverItsPartOfWhatALoopMoved) {
  const PointId moved = map_.add(pointAt(0));
  const PointId stays = map_.add(pointAt(1));
  MapUpdate update;
  for (PointId id = 100; id < 200; ++id) update.p_map_m[id] = {9, 9, 9};
  update.p_map_m[moved] = {0.5, 0, 2};
  map_.apply(update, 7);
  EXPECT_THAT(ids(), ElementsAre(moved, stays));
  EXPECT_TRUE(map_.find(moved)->p_map_m.isApprox(Eigen::Vector3d(0.5, 0, 2)));
  EXPECT_TRUE(map_.find(stays)->p_map_m.isApprox(Eigen::Vector3d(1, 0, 2)));
}

/// Ten thousand points go a metre up. What happens to them meanwhile finds them there.
TEST_F(LocalMapTest, WhatALoopMovedIsThereWhoeverLooks) {
  LocalMapOptions large = options();
  large.max_points = 20000;
  LocalMap map(large);
  MapUpdate loop;
  loop.movesTheMap = true;
  for (int i = 0; i < 10000; ++i) loop.p_map_m[map.add(pointAt(i))] = {static_cast<double>(i), 0, 3};
  map.apply(loop, 7);
  EXPECT_DOUBLE_EQ(map.points().at(5000).p_map_m.z(), 2.0) << "nobody has asked for it";
  EXPECT_DOUBLE_EQ(map.find(5000)->p_map_m.z(), 3.0);

  MapUpdate small;
  small.p_map_m[6000] = {0, 0, 4};
  small.recalledPoints[20001] = pointAt(0);
  small.recalledKeyframes[1] = {20001};
  map.apply(small, 8);
  map.movePoints(9000, Eigen::Isometry3d(Eigen::Translation3d(0, 0, 0.5)));
  for (int image = 0; image < 6; ++image) map.moveSome();
  EXPECT_DOUBLE_EQ(map.points().at(1).p_map_m.z(), 3.0);
  EXPECT_DOUBLE_EQ(map.points().at(6000).p_map_m.z(), 4.0);
  EXPECT_DOUBLE_EQ(map.points().at(8999).p_map_m.z(), 3.0);
  EXPECT_DOUBLE_EQ(map.points().at(9000).p_map_m.z(), 3.5);
  EXPECT_DOUBLE_EQ(map.points().at(20001).p_map_m.z(), 2.5) << "recalled to where it belongs, and moved since";

  MapUpdate adjustment = loop;
  adjustment.movesTheMap = false;
  for (auto& [id, p_map_m] : adjustment.p_map_m) p_map_m.z() = 5.0;
  map.apply(adjustment, 9);
  EXPECT_DOUBLE_EQ(map.points().at(5000).p_map_m.z(), 5.0) << "no loop: at once";
}

/// What is recalled is where it belongs already.
TEST_F(LocalMapTest, TheSideAPointWasSeenFromTurnsWithTheMap) {
  const PointId turned = map_.add(pointAt(0));
  const MapPoint before = *map_.find(turned);
  MapPoint recalled = pointAt(1);
  recalled.viewedFrom_map_m = {1, 0, 0};
  MapUpdate update;
  update.p_map_m = {{turned, {4, 0, 0}}, {99, recalled.p_map_m}};
  update.recalledPoints[99] = recalled;
  const Eigen::Matrix3d R = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitY()).toRotationMatrix();
  map_.apply(update, 7, R);
  const Eigen::Vector3d fromCamera_m = before.p_map_m - before.viewedFrom_map_m;
  EXPECT_TRUE(map_.find(turned)->p_map_m.isApprox(Eigen::Vector3d(4, 0, 0)));
  EXPECT_TRUE((map_.find(turned)->p_map_m - map_.find(turned)->viewedFrom_map_m).isApprox(R * fromCamera_m));
  EXPECT_EQ(map_.find(99)->viewedFrom_map_m, Eigen::Vector3d(1, 0, 0));
}

TEST_F(LocalMapTest, MovesPointsMadeFromOneOn) {
  const PointId older = map_.add(pointAt(0));
  const PointId first = map_.nextId();
  EXPECT_EQ(map_.add(pointAt(1)), first);
  const PointId later = map_.add(pointAt(2));
  const MapPoint before = *map_.find(later);
  const Eigen::Isometry3d quarterTurn(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()));
  map_.movePoints(first, quarterTurn);
  EXPECT_TRUE(map_.find(older)->p_map_m.isApprox(Eigen::Vector3d(0, 0, 2)));
  EXPECT_TRUE(map_.find(first)->p_map_m.isApprox(Eigen::Vector3d(0, 1, 2)));
  EXPECT_TRUE(map_.find(later)->p_map_m.isApprox(Eigen::Vector3d(0, 2, 2)));
  EXPECT_TRUE(map_.find(later)->viewedFrom_map_m.isApprox(quarterTurn * before.viewedFrom_map_m));
  EXPECT_NEAR(map_.find(later)->information_per_m2(1, 1), before.information_per_m2(0, 0), 1e-9) << "turned along";
}

TEST_F(LocalMapTest, AFusedPointHandsItsKeyframesOn) {
  const PointId old = map_.add(pointAt(0));
  const PointId twin = map_.add(pointAt(0.01));
  const PointId other = map_.add(pointAt(1));
  map_.addKeyframe(1, {old});
  map_.addKeyframe(2, {twin, other});
  MapUpdate update;
  update.fusedPoints[twin] = old;
  map_.apply(update, 7);
  EXPECT_THAT(ids(), ElementsAre(old, other));
  EXPECT_THAT(map_.neighbourhood({other}), ElementsAre(old, other));
  EXPECT_THAT(map_.neighbourhood({old}), ElementsAre(old, other));
}

TEST_F(LocalMapTest, ClearedItForgetsAllAndUsesNoIdTwice) {
  const PointId before = map_.add(pointAt(0));
  map_.addKeyframe(1, {before});
  map_.clear();
  EXPECT_THAT(ids(), IsEmpty());
  const PointId after = map_.add(pointAt(0));
  EXPECT_NE(before, after);
  EXPECT_THAT(map_.neighbourhood({before, after}), IsEmpty());
}

TEST_F(LocalMapTest, ARemovedKeyframeLeavesItsPoints) {
  const PointId a = map_.add(pointAt(0));
  const PointId b = map_.add(pointAt(1));
  map_.addKeyframe(1, {a, b});
  map_.addKeyframe(2, {b});
  MapUpdate update;
  update.removedKeyframes = {{1, 2, Eigen::Isometry3d::Identity()}, {99, 2, Eigen::Isometry3d::Identity()}};
  map_.apply(update, 7);
  EXPECT_THAT(ids(), ElementsAre(a, b));
  EXPECT_THAT(map_.neighbourhood({a}), IsEmpty());
  EXPECT_THAT(map_.neighbourhood({b}), ElementsAre(b));
}

TEST_F(LocalMapTest, RecallsWhatItForgotOfAKeyframe) {
  const PointId kept = map_.add(pointAt(0, 5));
  const PointId forgotten = map_.add(pointAt(1, 1));
  map_.addKeyframe(1, {kept, forgotten});
  for (int i = 0; i < 3; ++i) map_.add(pointAt(2, 9));
  map_.cull();
  ASSERT_EQ(map_.find(forgotten), nullptr);
  MapUpdate update;
  update.recalledKeyframes[1] = {kept, forgotten};
  update.recalledPoints = {{kept, pointAt(0)}, {forgotten, pointAt(1)}};
  map_.apply(update, 20);
  EXPECT_THAT(map_.neighbourhood({kept}), ElementsAre(kept, forgotten));
  map_.cull();
  EXPECT_NE(map_.find(forgotten), nullptr) << "others were not seen for longer";
}

}  // namespace
}  // namespace wardslam::odometry
