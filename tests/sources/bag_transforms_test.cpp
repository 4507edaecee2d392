#include "bag_transforms.h"

#include <gtest/gtest.h>

#include "sources/bag_edge.h"

namespace wardslam::sources {
namespace {

using test::edge;

class BagTransformsTest : public ::testing::Test {
 protected:
  BagTransformsTest() {
    tree.add(edge("odom", "base_link", 5));
    tree.add(edge("base_link", "camera_link", 1));
    tree.add(edge("camera_link", "color", 0.2));
    tree.add(edge("camera_link", "depth", 0.5));
  }
  BagTransforms tree;
};

TEST_F(BagTransformsTest, LeadUpAndDownTheTree) {
  EXPECT_NEAR(tree.T("base_link", "color")->translation().x(), 1.2, 1e-12);
  EXPECT_NEAR(tree.T("color", "base_link")->translation().x(), -1.2, 1e-12);
  EXPECT_NEAR(tree.T("depth", "color")->translation().x(), -0.3, 1e-12);
  EXPECT_FALSE(tree.T("color", "somewhere"));
}

TEST_F(BagTransformsTest, FindTheRobotByName) {
  EXPECT_EQ(tree.ancestor("color", {"base_footprint", "base_link"}), "base_link");
  EXPECT_FALSE(tree.ancestor("color", {"base_footprint"}));
  tree.add(edge("r1/base_link", "r1/camera", 1));
  EXPECT_EQ(tree.ancestor("r1/camera", {"base_link"}), "r1/base_link");
}

TEST_F(BagTransformsTest, SayWhatChanges) {
  tree.add(edge("odom", "base_link", 6));
  EXPECT_FALSE(tree.changing("base_link", "color"));
  tree.add(edge("base_link", "camera_link", 1.0005));  // rounding
  EXPECT_FALSE(tree.changing("base_link", "color"));
  tree.add(edge("base_link", "camera_link", 1.002));
  EXPECT_EQ(tree.changing("base_link", "color"), "camera_link");
  EXPECT_FALSE(tree.changing("color", "depth"));
}

TEST_F(BagTransformsTest, EndWhereFramesStandAboveThemselves) {
  tree.add(edge("color", "odom", 1));
  EXPECT_FALSE(tree.ancestor("color", {"nobody"}));
  EXPECT_FALSE(tree.T("color", "nobody"));
  EXPECT_TRUE(tree.T("base_link", "color"));
}

}  // namespace
}  // namespace wardslam::sources
