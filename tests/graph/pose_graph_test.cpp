#include "pose_graph.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "graph/hand_made_keyframe.h"
#include "graph/synthetic_walk.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::graph {
namespace {

using test::handMadeKeyframe;
using test::makePose;

using Edges = std::set<std::pair<KeyframeId, KeyframeId>>;

/// A square of 4 m, half a metre from node to node, measured with a turn too much at every step.
class Square {
 public:
  static constexpr KeyframeId kNodes = 32;

  Square() {
    const Eigen::Isometry3d error = makePose({0.004, 0.0, 0.0}, {0.0, 0.002, 0.01});
    truth_[1] = Eigen::Isometry3d::Identity();
    poses_.root = 1;
    poses_.nodes[1] = core::toMrpt(truth_[1]);
    for (KeyframeId id = 1; id < kNodes; ++id) {
      const bool isCorner = id % 8 == 0;
      const Eigen::Isometry3d T_id_next = makePose({0.5, 0.0, 0.0}, {0.0, 0.0, isCorner ? M_PI / 2 : 0.0});
      truth_[id + 1] = truth_[id] * T_id_next;
      poses_.nodes[id + 1] = core::toMrpt(pose(id) * T_id_next * error);
      addEdge(id, id + 1, T_id_next * error);
    }
  }

  void addTrueLoop() { addLoop(1, kNodes, truth_.at(1).inverse() * truth_.at(kNodes)); }

  /// Says that the camera was 3 m from where it was.
  void addWrongLoop() { addLoop(4, 20, makePose({3.0, 0.0, 0.0}) * truth_.at(4).inverse() * truth_.at(20)); }

  void optimiseWith(PoseGraphSolver solver) {
    PoseGraphOptions options;
    options.solver = solver;
    options.max_iterations = 100;
    optimise(poses_, loops_, {}, options);
  }

  [[nodiscard]] Eigen::Isometry3d pose(KeyframeId id) const { return core::fromMrpt(poses_.nodes.at(id)); }
  [[nodiscard]] double error_m(KeyframeId id) const { return test::distance_m(pose(id), truth_.at(id)); }
  [[nodiscard]] double greatestError_m() const {
    double greatest_m = 0.0;
    for (KeyframeId id = 1; id <= kNodes; ++id) greatest_m = std::max(greatest_m, error_m(id));
    return greatest_m;
  }

 private:
  void addEdge(KeyframeId from, KeyframeId to, const Eigen::Isometry3d& T_from_to) {
    PoseGraph::constraint_t edge;
    edge.mean = core::toMrpt(T_from_to);
    edge.cov_inv.setZero();
    for (int i = 0; i < 6; ++i) edge.cov_inv(i, i) = i < 3 ? 1.0 / (0.02 * 0.02) : 1.0 / (0.01 * 0.01);
    poses_.insertEdgeAtEnd(from, to, edge);
  }

  void addLoop(KeyframeId older, KeyframeId newer, const Eigen::Isometry3d& T_older_newer) {
    addEdge(older, newer, T_older_newer);
    loops_.emplace(older, newer);
  }

  PoseGraph poses_;
  Edges loops_;
  std::map<KeyframeId, Eigen::Isometry3d> truth_;
};

class PoseGraphTest : public ::testing::TestWithParam<PoseGraphSolver> {};

TEST_P(PoseGraphTest, OneLoopBringsTheEndBack) {
  Square square;
  square.addTrueLoop();
  ASSERT_GT(square.error_m(Square::kNodes), 0.5);
  square.optimiseWith(GetParam());
  EXPECT_LT(square.error_m(Square::kNodes), 0.03);
  EXPECT_LT(square.greatestError_m(), 0.2) << "spread over the way";
  EXPECT_TRUE(square.pose(1).isApprox(Eigen::Isometry3d::Identity())) << "the root holds still";
}

TEST_P(PoseGraphTest, WithoutALoopNothingMoves) {
  Square square;
  const Eigen::Isometry3d before = square.pose(Square::kNodes);
  square.optimiseWith(GetParam());
  EXPECT_TRUE(square.pose(Square::kNodes).isApprox(before, 1e-6));
}

INSTANTIATE_TEST_SUITE_P(Solvers, PoseGraphTest, testing::Values(PoseGraphSolver::Ceres, PoseGraphSolver::Levmarq),
                         [](const auto& suite) { return suite.param == PoseGraphSolver::Ceres ? "Ceres" : "Levmarq"; });

TEST(PoseGraph, TheRobustKernelBendsAWrongLoop) {
  Square square;
  square.addTrueLoop();
  square.addWrongLoop();
  Square trusting = square;
  square.optimiseWith(PoseGraphSolver::Ceres);
  EXPECT_LT(square.greatestError_m(), 0.25);
  trusting.optimiseWith(PoseGraphSolver::Levmarq);
  EXPECT_GT(trusting.greatestError_m(), 0.5) << "the baseline has no such kernel";
}

TEST(MakePoseGraph, TiesKeyframesByWhatTheyShareAndByLoops) {
  KeyframeGraph graph;
  const std::vector<odometry::PointId> five{1, 2, 3, 4, 5};
  graph.insert(handMadeKeyframe(1, five));
  graph.insert(handMadeKeyframe(2, {1, 2}));
  graph.insert(handMadeKeyframe(3, five));
  graph.insert(handMadeKeyframe(4, {9}));
  graph.insert(handMadeKeyframe(5, {20}, 2));
  graph.setPose(3, makePose({1, 2, 3}, {0.1, 0.2, 0.3}));
  PoseGraphOptions options;
  options.min_shared_points = 5;
  options.position_sigma_m = 0.1;
  options.rotation_sigma_rad = 0.01;
  Loop loop;
  loop.older = 1;
  loop.newer = 4;
  loop.inliers = 200;
  loop.T_older_newer = makePose({0, 0, 7});
  const auto poses = makePoseGraph(graph, 1, {loop}, options);

  EXPECT_EQ(poses.root, 1U);
  EXPECT_EQ(poses.nodes.size(), 4U) << "keyframe 5 is in another submap";
  Edges edges;
  for (const auto& [ends, edge] : poses.edges) edges.insert(ends);
  EXPECT_EQ(edges, (Edges{{1, 2}, {1, 3}, {2, 3}, {3, 4}, {1, 4}}));
  EXPECT_EQ(poses.edges.size(), 5U);

  const auto& strong = poses.edges.find({1, 3})->second;
  EXPECT_TRUE(core::fromMrpt(strong.mean).isApprox(makePose({1, 2, 3}, {0.1, 0.2, 0.3})));
  EXPECT_NEAR(strong.cov_inv(0, 0), 5.0 / 100.0 / (0.1 * 0.1), 1e-9) << "five of the hundred points of full weight";
  EXPECT_NEAR(strong.cov_inv(5, 5), 5.0 / 100.0 / (0.01 * 0.01), 1e-9);
  EXPECT_NEAR(poses.edges.find({3, 4})->second.cov_inv(0, 0), 1.0, 1e-9) << "shared nothing: a weak tie";
  const auto& closing = poses.edges.find({1, 4})->second;
  EXPECT_TRUE(core::fromMrpt(closing.mean).isApprox(makePose({0, 0, 7})));
  EXPECT_NEAR(closing.cov_inv(0, 0), 200.0, 1e-9);
}

}  // namespace
}  // namespace wardslam::graph
