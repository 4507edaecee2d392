#include "view_selection.h"

#include <gtest/gtest.h>

namespace wardslam::pipeline {
namespace {

/// Options as documented: 0.1 m, 0.06 rad, 0.5 s. The camera stands in the origin at first.
class ViewSelectionTest : public testing::Test {
 protected:
  ViewSelectionTest() {
    odometry_.state = odometry::State::Ok;
    odometry_.referenceKeyframe = 7;
    frame_.stamp_s = 10.0;
    frame_.segmentation.classIds.create(4, 6, CV_8UC1);
  }

  [[nodiscard]] bool isSelected() { return selection_.select(frame_, odometry_).has_value(); }
  void moveTo(double x_m) { odometry_.T_map_cam.translation().x() = x_m; }

  core::Frame frame_;
  odometry::OdometryResult odometry_;
  ViewSelection selection_{{}, false};
};

TEST_F(ViewSelectionTest, TheFirstFrameAndKeyframesAreAlwaysTaken) {
  EXPECT_TRUE(isSelected());
  EXPECT_FALSE(isSelected()) << "the same again";
  odometry_.keyframe = std::make_shared<odometry::Keyframe>();
  EXPECT_TRUE(isSelected());
}

TEST_F(ViewSelectionTest, OthersWhereTheCameraMovedSinceTheLastOneTaken) {
  ASSERT_TRUE(isSelected());
  moveTo(0.09);
  EXPECT_FALSE(isSelected());
  moveTo(0.11);
  EXPECT_TRUE(isSelected());
  moveTo(0.2);
  EXPECT_FALSE(isSelected()) << "0.2 m from the first, but 0.09 m from the last";
}

TEST_F(ViewSelectionTest, OthersWhereTheCameraTurned) {
  ASSERT_TRUE(isSelected());
  odometry_.T_map_cam.linear() = Eigen::AngleAxisd(0.05, Eigen::Vector3d::UnitY()).matrix();
  EXPECT_FALSE(isSelected());
  odometry_.T_map_cam.linear() = Eigen::AngleAxisd(0.07, Eigen::Vector3d::UnitY()).matrix();
  EXPECT_TRUE(isSelected());
}

TEST_F(ViewSelectionTest, OthersAfterHalfASecond) {
  ASSERT_TRUE(isSelected());
  frame_.stamp_s = 10.4;
  EXPECT_FALSE(isSelected());
  frame_.stamp_s = 10.5;
  EXPECT_TRUE(isSelected());
}

TEST_F(ViewSelectionTest, WithoutAPoseNone) {
  odometry_.state = odometry::State::Lost;
  EXPECT_FALSE(isSelected());
}

TEST_F(ViewSelectionTest, WithoutMasksNoneWhereTheyAreNeeded) {
  selection_ = ViewSelection({}, true);
  EXPECT_TRUE(isSelected());
  frame_.segmentation = {};
  odometry_.keyframe = std::make_shared<odometry::Keyframe>();
  EXPECT_EQ(selection_.withoutMasks(), 0U);
  EXPECT_FALSE(isSelected());
  EXPECT_EQ(selection_.withoutMasks(), 1U);
  selection_ = ViewSelection({}, false);
  EXPECT_TRUE(isSelected());
}

TEST_F(ViewSelectionTest, AViewHoldsWhatTheFrameShowsAndWhereItHangs) {
  odometry_.T_keyframe_cam.translation() = Eigen::Vector3d(1, 2, 3);
  frame_.camera.fx_px = 500;
  frame_.color_bgr.create(4, 6, CV_8UC3);
  frame_.depth_m.create(4, 6, CV_32FC1);
  frame_.mayMove.create(4, 6, CV_8UC1);
  const auto view = selection_.select(frame_, odometry_);
  ASSERT_TRUE(view);
  EXPECT_EQ(view->keyframe, 7U);
  EXPECT_FALSE(view->isKeyframe);
  EXPECT_EQ(view->T_keyframe_cam.translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(view->stamp_s, 10.0);
  EXPECT_EQ(view->camera.fx_px, 500);
  EXPECT_EQ(view->color_bgr.data, frame_.color_bgr.data) << "shared";
  EXPECT_EQ(view->depth_m.data, frame_.depth_m.data);
  EXPECT_EQ(view->mayMove.data, frame_.mayMove.data);
  EXPECT_EQ(view->segmentation.classIds.data, frame_.segmentation.classIds.data);
}

}  // namespace
}  // namespace wardslam::pipeline
