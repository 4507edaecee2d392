#include "bag_rig.h"

#include <gmock/gmock.h>

#include "sources/bag_edge.h"
#include "support/complaint.h"

namespace wardslam::sources {
namespace {

using test::edge;
using ::testing::AllOf;
using ::testing::HasSubstr;

bags::CameraInfo info(double focal_px) {
  bags::CameraInfo info;
  info.width_px = 640;
  info.height_px = 480;
  info.k = {focal_px, 0, 320, 0, focal_px, 240, 0, 0, 1};
  return info;
}

class BagRigTest : public ::testing::Test {
 protected:
  BagRigTest() {
    found.colorFrame = "color";
    found.depthFrame = "depth";
    found.colorInfo = info(600);
  }
  [[nodiscard]] BagRig rig(const std::string& depthTopic = "/depth/image_raw") const {
    return rigOf(found, "/color/image_raw", depthTopic, std::nullopt, "f.bag");
  }
  BagSurvey found;
};

TEST_F(BagRigTest, DepthIsRegisteredWhereNameOrFrameSaySo) {
  EXPECT_FALSE(rig("/aligned_depth_to_color/image_raw").T_depth_color);
  found.depthFrame = "color";
  found.depthInfo = info(600);
  EXPECT_FALSE(rig().T_depth_color);
  EXPECT_EQ(rig().depth.fx_px, 600);
}

TEST_F(BagRigTest, OtherDepthNeedsATransform) {
  found.depthInfo = info(400);
  EXPECT_THAT(test::complaintOf([&] { return rig(); }), AllOf(HasSubstr("calibrations differ"), HasSubstr("'depth'"),
                                                              HasSubstr("align_depth"), HasSubstr("/tf_static")));
  found.transforms.add(edge("link", "color", 0.1));
  found.transforms.add(edge("link", "depth", 0.4));
  EXPECT_EQ(rig().depth.fx_px, 400);
  EXPECT_NEAR(rig().T_depth_color->translation().x(), -0.3, 1e-12);
}

// RealSense's own recorder calls the frames of all its cameras "0".
TEST_F(BagRigTest, AFrameWithoutANameSaysNothing) {
  found.colorFrame = found.depthFrame = "0";
  found.depthInfo = info(400);
  EXPECT_THAT(test::complaintOf([&] { return rig(); }), HasSubstr("calibrations differ"));
}

TEST_F(BagRigTest, DepthOfUnknownPlaceIsNotTaken) {
  EXPECT_THAT(test::complaintOf([&] { return rig(); }), HasSubstr("no calibration (camera_info) beside it"));
}

TEST_F(BagRigTest, TheRobotIsWhatOdometryMovesOrBaseLink) {
  found.depthFrame = "color";
  EXPECT_FALSE(rig().T_base_color);
  EXPECT_THAT(rig().assumed, HasSubstr("the camera is taken for one"));
  found.transforms.add(edge("base_footprint", "base_link", 0.0));
  found.transforms.add(edge("base_link", "color", 0.25));
  EXPECT_EQ(rig().baseFrame, "base_link");
  EXPECT_NEAR(rig().T_base_color->translation().x(), 0.25, 1e-12);
  found.robotFrame = "base_footprint";
  EXPECT_EQ(rig().baseFrame, "base_footprint");
}

TEST_F(BagRigTest, ACameraThatMovesOnTheRobotIsTakenForOneItself) {
  found.depthFrame = "color";
  found.transforms.add(edge("base_link", "color", 0.25));
  found.transforms.add(edge("base_link", "color", 0.5));
  EXPECT_FALSE(rig().T_base_color);
  EXPECT_THAT(rig().assumed, HasSubstr("moves on the robot"));
}

}  // namespace
}  // namespace wardslam::sources
