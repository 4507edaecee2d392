#include "bundle_adjustment.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "graph/hand_made_keyframe.h"
#include "graph/synthetic_walk.h"

namespace wardslam::graph {
namespace {

using test::handMadeKeyframe;
using test::makePose;
using testing::ElementsAre;
using testing::IsEmpty;

/// Six keyframes, the first true, the others and all points off by centimetres.
class AdjustTest : public ::testing::Test {
 protected:
  void build(const test::Noise& noise) {
    test::SyntheticWalk walk(noise);
    for (int i = 0; i < 6; ++i) {
      auto keyframe = walk.step();
      if (keyframe->id == kBent) keyframe->features.keypoints[kOutlier].undistorted_px.x += 40.0F;
      graph_.insert(keyframe);
    }
    outlier_ = graph_.keyframes().at(kBent).keyframe->sightings[kOutlier].point;
    for (KeyframeId id = 2; id <= 6; ++id) {
      const double sign = id % 2 == 0 ? 1.0 : -1.0;
      graph_.setPose(id, walk.T_first_cam(id) * makePose({0.02 * sign, -0.01, 0.02}, {0.01, 0.01 * sign, -0.01}));
    }
    for (const auto& [id, node] : graph_.points()) {
      const double sign = id % 3 == 0 ? 1.0 : -1.0;
      moved_m_[id] = node.point.p_map_m + Eigen::Vector3d(0.01 * sign, 0.02, -0.01);
    }
    for (const auto& [id, p_m] : moved_m_) graph_.setPosition(id, p_m);
    for (KeyframeId id = 1; id <= 6; ++id) truth_[id] = walk.T_first_cam(id);
    for (const auto& [id, node] : graph_.points()) p_true_m_[id] = walk.p_first_m(id);
  }

  /// Root of the mean square over points that were seen from more than one place.
  [[nodiscard]] double pointError_m() const {
    double sum = 0.0;
    int count = 0;
    for (const auto& [id, node] : graph_.points()) {
      if (node.seenBy.size() < 3) continue;
      sum += (node.point.p_map_m - p_true_m_.at(id)).squaredNorm();
      ++count;
    }
    return std::sqrt(sum / count);
  }

  [[nodiscard]] std::size_t sightings() const {
    std::size_t count = 0;
    for (const auto& [id, node] : graph_.keyframes()) count += node.keypointOf.size();
    return count;
  }

  static constexpr KeyframeId kBent = 3;
  static constexpr std::size_t kOutlier = 10;
  KeyframeGraph graph_;
  PointId outlier_ = 0;
  BundleAdjustmentOptions options_;
  std::map<KeyframeId, Eigen::Isometry3d> truth_;
  std::map<PointId, Eigen::Vector3d> moved_m_;
  std::map<PointId, Eigen::Vector3d> p_true_m_;
};

TEST_F(AdjustTest, FindsPosesAndPointsToWithinTheNoise) {
  build({0.5, 0.5, 0});
  const auto update = adjust(graph_, globalWindow(graph_, 1), options_, 20);
  EXPECT_TRUE(graph_.keyframes().at(1).T_map_cam.isApprox(Eigen::Isometry3d::Identity())) << "the frame holds still";
  for (KeyframeId id = 2; id <= 6; ++id) {
    const Eigen::Isometry3d& T_map_cam = graph_.keyframes().at(id).T_map_cam;
    EXPECT_LT(test::distance_m(T_map_cam, truth_.at(id)), 0.006) << id << ": was off by 3 cm";
    EXPECT_LT(test::angle_rad(T_map_cam, truth_.at(id)), 0.003) << id << ": was off by 0.017 rad";
    EXPECT_TRUE(update.T_map_cam.at(id).isApprox(T_map_cam));
  }
  EXPECT_EQ(update.T_map_cam.count(1), 0U);
  EXPECT_LT(pointError_m(), 0.01) << "half the Kinect's noise, which is 1 cm at 2.5 m, 4 cm at 5 m; was 2.5 cm more";
}

TEST_F(AdjustTest, DropsAGrossOutlierAndNearlyNothingElse) {
  build({0.5, 0.5, 0});
  const std::size_t before = sightings();
  ASSERT_GT(graph_.points().at(outlier_).seenBy.size(), 2U);
  adjust(graph_, globalWindow(graph_, 1), options_, 20);
  EXPECT_EQ(graph_.keyframes().at(kBent).keypointOf.count(outlier_), 0U);
  EXPECT_EQ(graph_.points().at(outlier_).seenBy.count(kBent), 0U);
  EXPECT_GT(static_cast<double>(sightings()), 0.995 * static_cast<double>(before));
}

TEST_F(AdjustTest, AStopThatIsSetLeavesThePoses) {
  build({});
  const auto T_map_cam = graph_.keyframes().at(4).T_map_cam;
  const std::atomic<bool> stop{true};
  adjust(graph_, globalWindow(graph_, 1), options_, 20, &stop);
  EXPECT_TRUE(graph_.keyframes().at(4).T_map_cam.isApprox(T_map_cam, 1e-9));
}

TEST_F(AdjustTest, APointSeenOnceStays) {
  build({});
  const auto once = std::find_if(graph_.points().begin(), graph_.points().end(),
                                 [](const auto& point) { return point.second.seenBy.size() == 1; });
  ASSERT_NE(once, graph_.points().end());
  const PointId id = once->first;
  adjust(graph_, globalWindow(graph_, 1), options_, 20);
  EXPECT_TRUE(graph_.points().at(id).point.p_map_m.isApprox(moved_m_.at(id)));
}

/// Keyframes at one place that see points in one line: nothing holds them from turning about it, but their floor.
class HingeTest : public ::testing::Test {
 protected:
  static constexpr KeyframeId kNewest = 5;

  HingeTest() {
    for (KeyframeId id = 1; id <= kNewest; ++id) {
      auto keyframe = handMadeKeyframe(id, {1, 2, 3, 4, 5, 6, 7, 8});
      keyframe->camera.fx_px = keyframe->camera.fy_px = 300.0;
      keyframe->camera.cx_px = 120.0;
      keyframe->camera.cy_px = 100.0;  // the line's row
      keyframe->ground = core::GroundPlane{-Eigen::Vector3d::UnitY(), 1.1, Eigen::Matrix3d::Zero()};
      graph_.insert(keyframe);
      graph_.setFloor(id, 1);
    }
    graph_.setPose(kNewest, turned());
  }

  /// By a degree about the line.
  [[nodiscard]] static Eigen::Isometry3d turned() {
    return makePose({0, 0, 2}) * makePose({0, 0, 0}, {kDegree, 0, 0}) * makePose({0, 0, -2});
  }

  [[nodiscard]] double tilt_rad(AdjustmentWindow window) {
    for (PointId id = 1; id <= 8; ++id) window.points.insert(id);
    adjust(graph_, window, {}, 50);
    return test::angle_rad(graph_.keyframes().at(kNewest).T_map_cam, Eigen::Isometry3d::Identity());
  }

  static constexpr double kDegree = M_PI / 180.0;
  KeyframeGraph graph_;
};

TEST_F(HingeTest, TheFloorHoldsWhatPointsDoNot) { EXPECT_LT(tilt_rad({{kNewest}, {1, 2, 3, 4}, {}}), 0.03 * kDegree); }

TEST_F(HingeTest, SoDoesAFloorThatMostlyLiesElsewhere) {
  EXPECT_LT(tilt_rad({{kNewest}, {1}, {}}), 0.2 * kDegree) << "its plane has the one that is turned in it";
}

TEST_F(HingeTest, WithoutAFloorNothingDoes) {
  for (KeyframeId id = 1; id <= kNewest; ++id) graph_.setFloor(id, 0);
  EXPECT_NEAR(tilt_rad({{kNewest}, {1, 2, 3, 4}, {}}), kDegree, 0.01 * kDegree);
}

TEST_F(HingeTest, NorDoesAFloorThatOnlyTwoStandOn) {
  for (const KeyframeId id : {2, 3, 4}) graph_.setFloor(id, 0);
  EXPECT_NEAR(tilt_rad({{kNewest}, {1, 2, 3, 4}, {}}), kDegree, 0.01 * kDegree);
}

class WindowTest : public ::testing::Test {
 protected:
  WindowTest() {
    graph_.insert(handMadeKeyframe(1, {1, 2}));
    graph_.insert(handMadeKeyframe(2, {1, 2, 3, 4}));
    graph_.insert(handMadeKeyframe(3, {3, 4, 5, 6, 7}));
    graph_.insert(handMadeKeyframe(4, {4, 5, 6, 7}));
    graph_.insert(handMadeKeyframe(5, {5, 6, 8}));
    graph_.insert(handMadeKeyframe(6, {20}, 2));
    options_.min_shared_points = 2;
    options_.window = 2;
  }

  KeyframeGraph graph_;
  BundleAdjustmentOptions options_;
};

TEST_F(WindowTest, TheNewestAndItsNextMoveOthersThatSeeTheirPointsHoldStill) {
  const auto window = localWindow(graph_, 4, options_);
  EXPECT_THAT(window.moved, ElementsAre(3, 4)) << "3 shares four points with it, 5 just two";
  EXPECT_THAT(window.points, ElementsAre(3, 4, 5, 6, 7));
  EXPECT_THAT(window.fixed, ElementsAre(2, 5));
}

TEST_F(WindowTest, FewHoldStillWhenToldSo) {
  options_.max_fixed_keyframes = 1;
  EXPECT_THAT(localWindow(graph_, 4, options_).fixed, testing::SizeIs(1));
}

TEST_F(WindowTest, SomethingAlwaysHoldsStill) {
  const auto atTheStart = localWindow(graph_, 2, options_);
  EXPECT_EQ(atTheStart.moved.count(1), 0U) << "the first keyframe is the map frame";
  EXPECT_EQ(atTheStart.fixed.count(1), 1U);
  const auto alone = localWindow(graph_, 6, options_);
  EXPECT_THAT(alone.moved, IsEmpty());
  EXPECT_THAT(alone.fixed, ElementsAre(6));
}

TEST_F(WindowTest, TheGlobalOneIsOneSubmap) {
  const auto window = globalWindow(graph_, 1);
  EXPECT_THAT(window.fixed, ElementsAre(1));
  EXPECT_THAT(window.moved, ElementsAre(2, 3, 4, 5));
  EXPECT_EQ(window.points.count(20), 0U);
  EXPECT_EQ(window.points.size(), 8U);
}

/// A map of an earlier run, keyframes 1 and 2, and a run that goes on in it.
class GoingOnWindowTest : public WindowTest {
 protected:
  static std::vector<PointId> points(PointId first, PointId end) {
    std::vector<PointId> ids(end - first);
    std::iota(ids.begin(), ids.end(), first);
    return ids;
  }

  void goOn(PointId firstSeen) {
    graph_ = {};
    graph_.restore(handMadeKeyframe(1, points(1, 20)), {});
    graph_.restore(handMadeKeyframe(2, points(10, 40)), {});
    graph_.insert(handMadeKeyframe(3, points(firstSeen, 60)));
    graph_.insert(handMadeKeyframe(4, points(40, 80)));
  }
};

TEST_F(GoingOnWindowTest, WhatIsSettledHoldsStillWhereItSeesWhatMoves) {
  goOn(20);
  const auto window = globalWindow(graph_, 1);
  EXPECT_THAT(window.moved, ElementsAre(3, 4));
  EXPECT_THAT(window.fixed, ElementsAre(2)) << "the first sees nothing that moves";
  EXPECT_EQ(window.points.count(19), 0U);
  options_.window = 10;
  const auto local = localWindow(graph_, 3, options_);
  EXPECT_THAT(local.moved, ElementsAre(3, 4));
  EXPECT_THAT(local.fixed, ElementsAre(2));
}

TEST_F(GoingOnWindowTest, WhatIsSettledAndSharesLittleIsNotEnoughToHoldOn) {
  goOn(38);
  const auto window = globalWindow(graph_, 1);
  EXPECT_THAT(window.moved, ElementsAre(4));
  EXPECT_THAT(window.fixed, ElementsAre(2, 3)) << "two points tell of no pose";
}

TEST_F(GoingOnWindowTest, WhatGaveWayMovesAsAnyOther) {
  goOn(20);
  graph_.unsettle(1);
  EXPECT_THAT(globalWindow(graph_, 1).moved, ElementsAre(2, 3, 4));
}

}  // namespace
}  // namespace wardslam::graph
