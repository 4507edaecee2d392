#include "floor_ties.h"

#include <gtest/gtest.h>

#include <cmath>

#include "floors.h"
#include "graph/floor_walk.h"
#include "graph/synthetic_walk.h"
#include "pose_graph.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::graph {
namespace {

using test::FloorWalk;
using test::makePose;

constexpr double kDegree = M_PI / 180.0;
constexpr KeyframeId kKeyframes = 61;

/// Keyframes in a row that are tied by what they say of each other, all on one floor.
class FloorTiesTest : public ::testing::Test {
 protected:
  void drive(const FloorWalk& walk, const Eigen::Isometry3d& slip, KeyframeId keyframes = kKeyframes) {
    for (KeyframeId id = 1; id <= keyframes; ++id) {
      graph_.insert(walk.keyframe(id, slip));
      graph_.setFloor(id, 1);
    }
  }

  [[nodiscard]] std::set<KeyframeId> all() const {
    std::set<KeyframeId> all;
    for (const auto& [id, node] : graph_.keyframes()) all.insert(id);
    return all;
  }

  /// The solver's poses with these floors.
  [[nodiscard]] std::map<KeyframeId, Eigen::Isometry3d> solved(const FloorTies& floors) const {
    PoseGraph poses;
    poses.root = 1;
    for (const auto& [id, node] : graph_.keyframes()) poses.nodes[id] = core::toMrpt(node.T_map_cam);
    for (const auto& [id, node] : graph_.keyframes()) {
      if (id == 1) continue;
      PoseGraph::constraint_t edge;
      edge.mean = core::toMrpt(graph_.keyframes().at(id - 1).T_map_cam.inverse() * node.T_map_cam);
      edge.cov_inv.setZero();
      for (int i = 0; i < 6; ++i) edge.cov_inv(i, i) = i < 3 ? 1.0 / (0.02 * 0.02) : 1.0 / (kEdge_rad * kEdge_rad);
      poses.insertEdgeAtEnd(id - 1, id, edge);
    }
    PoseGraphOptions options;
    options.max_iterations = 200;
    optimise(poses, {}, {}, options, floors);
    std::map<KeyframeId, Eigen::Isometry3d> T_map_cam;
    for (const auto& [id, pose] : poses.nodes) T_map_cam[id] = core::fromMrpt(pose);
    return T_map_cam;
  }

  static constexpr double kEdge_rad = 0.01;
  KeyframeGraph graph_;
};

/// Pitch drifts by δ a step, and the height of the end by δ N²/2 steps. A floor seen to r per keyframe, beside edges of
/// q, leaves a lag of δ/λ with λ = q/r, and as much again by which the floor's plane leans for it: 2 δ/λ, or height by
/// δ/λ N steps, less by λN/2. r is ten times what floors are seen to, as edges are taken for ten times too unsure.
TEST_F(FloorTiesTest, TakeDriftInHeightAway) {
  const double drift_rad = 0.02 * kDegree;
  drive(FloorWalk(test::levelGround), makePose(Eigen::Vector3d::Zero(), {drift_rad, 0.0, 0.0}));
  const auto rise_m = [](const auto& poses) { return std::abs(poses.at(kKeyframes).translation().z() - 1.1); };
  const double without_m = rise_m(solved({}));
  const double steps = kKeyframes - 1;
  EXPECT_NEAR(without_m, drift_rad * steps * steps / 2.0 * FloorWalk::kStep_m, 0.01);
  const double r_rad = 10.0 * std::hypot(0.2 * kDegree, 0.0017);
  const double lambda = kEdge_rad / r_rad;
  const double with_m = rise_m(solved(FloorTies(graph_, all())));
  EXPECT_NEAR(without_m / with_m, lambda * steps / 2.0, 0.3 * lambda * steps / 2.0) << with_m << " m";
}

TEST_F(FloorTiesTest, LeaveARampAsItIs) {
  const FloorWalk walk(test::ramp);
  for (KeyframeId id = 1; id <= 40; ++id) {
    graph_.insert(walk.keyframe(id));
    findFloor(graph_, id, 1);
  }
  const auto after = solved(FloorTies(graph_, all()));
  EXPECT_NEAR(after.at(40).translation().z() - after.at(1).translation().z(), 3.0 * std::tan(3.0 * kDegree), 0.0002);
}

TEST_F(FloorTiesTest, LeaveAllAsItIsWhereNoFloorIsKnown) {
  drive(FloorWalk(test::levelGround), makePose(Eigen::Vector3d::Zero(), {0.001, 0.0, 0.0}));
  for (const KeyframeId id : all()) graph_.setFloor(id, 0);
  const auto without = solved({});
  const auto with = solved(FloorTies(graph_, all()));
  for (const KeyframeId id : all()) EXPECT_EQ(without.at(id).matrix(), with.at(id).matrix());
}

TEST_F(FloorTiesTest, APlaneIsVariableWhereAllThatStandOnItAreThere) {
  drive(FloorWalk(test::levelGround), Eigen::Isometry3d::Identity(), 5);
  EXPECT_EQ(FloorTies(graph_, {1, 2, 3, 4, 5}).variablePlanes().size(), 1U);
  EXPECT_TRUE(FloorTies(graph_, {2, 3, 4, 5}).variablePlanes().empty());
  EXPECT_TRUE(FloorTies(graph_, {17}).variablePlanes().empty());
}

TEST_F(FloorTiesTest, APlaneThatIsHeldIsConstant) {
  drive(FloorWalk(test::levelGround), Eigen::Isometry3d::Identity(), 3);
  graph_.hold();
  EXPECT_TRUE(FloorTies(graph_, {1, 2, 3}).variablePlanes().empty());
}

}  // namespace
}  // namespace wardslam::graph
