#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include <memory>

#include "support/hand_made_map.h"
#include "support/temporary_folder.h"
#include "wardslam/core/errors.h"
#include "wardslam/exchange/map_export.h"

namespace wardslam::exchange {
namespace {

/// One keyframe at the origin that looks along x and saw a wall of points at x = 2.
mapping::SemanticMap makeWall() {
  mapping::SemanticMap map;
  map.keyframes[1] = {};
  for (int i = -10; i <= 10; ++i) {
    mapping::SemanticPoint point;
    point.p_cam_m = {2.01F, 0.05F * static_cast<float>(i) + 0.01F, 0.01F};
    map.cloud[1].points.push_back(point);
  }
  return map;
}

class ExportOctomapTest : public testing::Test {
 protected:
  static bool isOccupied(const octomap::OcTree& tree, float x) {
    const auto* node = tree.search(x, 0.01, 0.01);
    return node != nullptr && tree.isNodeOccupied(node);
  }
  static bool isFree(const octomap::OcTree& tree, float x) {
    const auto* node = tree.search(x, 0.01, 0.01);
    return node != nullptr && !tree.isNodeOccupied(node);
  }
  static void expectWall(const octomap::OcTree& tree) {
    EXPECT_TRUE(isOccupied(tree, 2.01F));
    EXPECT_TRUE(isFree(tree, 1.0F));
    EXPECT_EQ(tree.search(2.5, 0.01, 0.01), nullptr) << "nobody saw behind the wall";
  }

  test::TemporaryFolder folder_;
};

TEST_F(ExportOctomapTest, BinaryTreesHaveWallsAndFreeSpace) {
  const std::string file = (folder_.path() / "wall.bt").string();
  exportOctomap(makeWall(), file);
  const octomap::OcTree tree(file);
  EXPECT_DOUBLE_EQ(tree.getResolution(), 0.05);
  expectWall(tree);
}

TEST_F(ExportOctomapTest, ColouredPointsMakeTheOnlyKindOfTreeThatBinaryFilesCanHold) {
  auto map = makeWall();
  for (auto& point : map.cloud[1].points) point.color_rgb = {200, 10, 30};
  const auto file = folder_.path() / "wall.bt";
  exportOctomap(map, file);
  const std::string text = test::readText(file);
  EXPECT_EQ(text.substr(0, 29), "# Octomap OcTree binary file\n");
  EXPECT_NE(text.find("\nid OcTree\n"), std::string::npos) << "octovis reads no .bt of another kind";
  expectWall(octomap::OcTree(file.string()));
}

TEST_F(ExportOctomapTest, TreesWithProbabilitiesToo) {
  const std::string file = (folder_.path() / "wall.ot").string();
  exportOctomap(makeWall(), file, 0.1);
  const std::unique_ptr<octomap::AbstractOcTree> tree(octomap::AbstractOcTree::read(file));
  const auto* const occupancy = dynamic_cast<const octomap::OcTree*>(tree.get());
  ASSERT_NE(occupancy, nullptr);
  EXPECT_DOUBLE_EQ(occupancy->getResolution(), 0.1);
  expectWall(*occupancy);
}

TEST_F(ExportOctomapTest, RaysThatPassCloseByDoNotWearSurfacesAway) {
  auto map = makeWall();
  for (std::uint64_t id = 2; id < 30; ++id) {  // each looks along the wall and sees something beyond its end
    map.keyframes[id].T_map_cam.translation() = Eigen::Vector3d(2.01, -1.0, 0.01);
    mapping::SemanticPoint beyond;
    beyond.p_cam_m = {0.0F, 3.0F, 0.0F};
    map.cloud[id].points.push_back(beyond);
  }
  const std::string file = (folder_.path() / "wall.bt").string();
  exportOctomap(map, file);
  EXPECT_TRUE(isOccupied(octomap::OcTree(file), 2.01F));
}

TEST_F(ExportOctomapTest, OtherNamesAreRefused) {
  EXPECT_THROW(exportOctomap(makeWall(), folder_.path() / "wall.octomap"), core::InputError);
}

}  // namespace
}  // namespace wardslam::exchange
