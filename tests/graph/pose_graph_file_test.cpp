#include "wardslam/graph/pose_graph_file.h"

#include <gmock/gmock.h>
#include <mrpt/graphs/CNetworkOfPoses.h>

#include <fstream>

#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::graph {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

std::shared_ptr<odometry::Keyframe> makeKeyframe(KeyframeId id) {
  auto keyframe = std::make_shared<odometry::Keyframe>();
  keyframe->id = id;
  keyframe->T_map_cam = Eigen::Translation3d(0.5 * static_cast<double>(id), 1.0, 1.2) *
                        Eigen::AngleAxisd(0.1 * static_cast<double>(id), Eigen::Vector3d(1, 2, 3).normalized());
  return keyframe;
}

/// Three keyframes that share nothing, one of another piece, and a loop from the first to the third.
SavedGraph makeGraph() {
  SavedGraph graph;
  for (KeyframeId id = 1; id <= 4; ++id) {
    const auto keyframe = makeKeyframe(id);
    if (id > 1)
      keyframe->T_previous_cam = Eigen::Isometry3d(Eigen::Translation3d(0.4, 0.1, 0.01 * static_cast<double>(id)));
    keyframe->submap = id == 4 ? 7 : 0;
    graph.keyframes.push_back(keyframe);
  }
  Loop loop;
  loop.older = 1;
  loop.newer = 3;
  loop.T_older_newer = Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, -2, 0.5).normalized());
  loop.inliers = 50;
  graph.loops.push_back(loop);
  return graph;
}

TEST(PoseGraphFile, GivesNodesBack) {
  const test::TemporaryFolder folder;
  const auto graph = makeGraph();
  writePoseGraph(graph, folder.path() / "a.graph");
  const auto T_map_cam = readPoseGraph(folder.path() / "a.graph");
  ASSERT_EQ(T_map_cam.size(), 3U);  // the piece that is no part of the map is left out
  for (KeyframeId id = 1; id <= 3; ++id) {
    EXPECT_TRUE(T_map_cam.at(id).isApprox(graph.keyframes[id - 1]->T_map_cam, 1e-5)) << id;
  }
}

TEST(PoseGraphFile, EdgesAreReadByMrptAsTheyWereMeant) {
  const test::TemporaryFolder folder;
  const auto graph = makeGraph();
  writePoseGraph(graph, folder.path() / "a.graph");
  mrpt::graphs::CNetworkOfPoses3DInf read;
  read.loadFromTextFile((folder.path() / "a.graph").string());
  ASSERT_EQ(read.edges.count({1, 3}), 1U);
  const auto& loop = read.edges.find({1, 3})->second;
  EXPECT_TRUE(core::fromMrpt(loop.mean).isApprox(graph.loops[0].T_older_newer, 1e-5));
  const PoseGraphOptions options;
  for (int i = 0; i < 6; ++i) {
    const double sigma = i < 3 ? options.position_sigma_m : options.rotation_sigma_rad;
    EXPECT_NEAR(loop.cov_inv(i, i), 0.5 / (sigma * sigma), 1e-6) << i;  // 50 points of 100
  }
  // From one to the next: what tracking measured, which is not where they stand.
  ASSERT_EQ(read.edges.count({2, 3}), 1U);
  const auto& step = read.edges.find({2, 3})->second;
  EXPECT_TRUE(core::fromMrpt(step.mean).isApprox(*graph.keyframes[2]->T_previous_cam, 1e-5));
}

TEST(PoseGraphFile, OfEdgesWithTheSameEndsALoopIsWritten) {
  const test::TemporaryFolder folder;
  auto graph = makeGraph();
  graph.loops[0].older = 2;  // next to the newer
  writePoseGraph(graph, folder.path() / "a.graph");
  mrpt::graphs::CNetworkOfPoses3DInf read;
  read.loadFromTextFile((folder.path() / "a.graph").string());
  ASSERT_EQ(read.edges.count({2, 3}), 1U);
  EXPECT_TRUE(core::fromMrpt(read.edges.find({2, 3})->second.mean).isApprox(graph.loops[0].T_older_newer, 1e-5));
}

TEST(PoseGraphFile, RefusesWhatIsNone) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "text.graph") << "no graph\n";
  std::ofstream(folder.path() / "empty.graph") << "";
  for (const char* name : {"text.graph", "empty.graph", "absent.graph"}) {
    EXPECT_THAT([&] { static_cast<void>(readPoseGraph(folder.path() / name)); },
                ThrowsMessage<core::InputError>(HasSubstr(name)));
  }
  EXPECT_THROW(writePoseGraph(makeGraph(), folder.path() / "no/such/folder.graph"), core::InputError);
}

}  // namespace
}  // namespace wardslam::graph
