#include "keyframe_scans.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include "support/temporary_folder.h"
#include "support/textured_room_scan.h"
#include "wardslam/sources/frame_builder.h"

namespace wardslam::mrpt_slam {
namespace {

using mrpt::obs::CObservation3DRangeScan;

/// A camera 1.2 m above the floor that looks to the left of the robot; columns 0…159 of its image move.
class KeyframeScansTest : public ::testing::Test {
 protected:
  KeyframeScansTest() {
    auto scan = test::observe(room_, 0);
    scan->sensorPose = mrpt::poses::CPose3D(0.0, 0.0, 1.2, M_PI / 2.0, 0.0, 0.0);
    frame_ = sources::FrameBuilder().build(scan);
    frame_.mayMove = cv::Mat(240, 320, CV_8UC1, cv::Scalar(0));
    frame_.mayMove.colRange(0, 160).setTo(255);
  }

  void see(odometry::KeyframeId keyframe) {
    odometry::OdometryResult odometry;
    auto seen = std::make_shared<odometry::Keyframe>();
    seen->id = keyframe;
    odometry.keyframe = seen;
    scans_.onFrame(frame_, odometry);
  }

  const test::TexturedRoom room_;
  core::Frame frame_;
  KeyframeScans scans_{MapBuilderOptions()};
};

TEST_F(KeyframeScansTest, HoldThePointsThatDoNotMoveInTheSensorsFrame) {
  mrpt::obs::CSensoryFrame observed;
  observed.insert(frame_.observation);
  scans_.setObserved(observed);
  see(7);
  const auto& scan = scans_.all().at(7);
  EXPECT_TRUE(scan.T_base_cam.isApprox(frame_.T_base_cam));
  const auto points = scan.observed->getObservationByClass<CObservation3DRangeScan>();
  ASSERT_TRUE(points);
  EXPECT_EQ(points->timestamp, frame_.observation->timestamp);
  ASSERT_EQ(points->points3D_x.size(), 27U * 40U) << "every sixth column from 162 to 318";
  for (std::size_t i = 0; i < points->points3D_x.size(); ++i) {
    EXPECT_GE(points->points3D_idxs_x[i], 160);
    EXPECT_LT(points->points3D_y[i], 0.0F) << "the right half of the image is to the right";
    const double depth_m = frame_.depth_m.at<float>(points->points3D_idxs_y[i], points->points3D_idxs_x[i]);
    EXPECT_NEAR(points->points3D_x[i], depth_m, 1e-4) << "x is where it looks";
  }
}

/// Of a sensor whose colour camera is 3 cm to the left of its depth camera: as from the colour camera.
TEST_F(KeyframeScansTest, WithImagesHoldTheDepthOfWhatDoesNotMove) {
  const test::TemporaryFolder folder;
  MapBuilderOptions options;
  options.images = folder.path().string();
  KeyframeScans scans(options);
  const auto apart = CObservation3DRangeScan::Create(*frame_.observation);
  apart->relativePoseIntensityWRTDepth = mrpt::poses::CPose3D(0.0, 0.03, 0.0, -M_PI / 2, 0.0, -M_PI / 2);
  const auto mayMove = frame_.mayMove;
  frame_ = sources::FrameBuilder().build(apart);
  frame_.mayMove = mayMove;
  mrpt::obs::CSensoryFrame observed;
  observed.insert(frame_.observation);
  scans.setObserved(observed);
  odometry::OdometryResult odometry;
  odometry.keyframe = std::make_shared<odometry::Keyframe>();
  scans.onFrame(frame_, odometry);
  const auto kept = scans.all().begin()->second.observed->getObservationByClass<CObservation3DRangeScan>();
  kept->load();
  const auto again = sources::FrameBuilder().build(kept);
  EXPECT_TRUE(again.T_base_cam.isApprox(frame_.T_base_cam, 1e-9));
  ASSERT_EQ(again.depth_m.size(), frame_.depth_m.size());
  EXPECT_LT(cv::norm(again.depth_m.colRange(160, 320), frame_.depth_m.colRange(160, 320), cv::NORM_INF), 0.00051);
  EXPECT_EQ(cv::countNonZero(again.depth_m.colRange(0, 160)), 0);
  EXPECT_GT(cv::countNonZero(again.depth_m), 1000);
  EXPECT_EQ(cv::norm(again.color_bgr, frame_.color_bgr, cv::NORM_INF), 0.0);
}

TEST_F(KeyframeScansTest, KeepWhatElseWasSeenAndNoOtherImages) {
  mrpt::obs::CSensoryFrame observed;
  const auto laser = mrpt::obs::CObservation2DRangeScan::Create();
  observed.insert(CObservation3DRangeScan::Create());
  observed.insert(laser);
  observed.insert(frame_.observation);
  scans_.setObserved(observed);
  see(1);
  EXPECT_EQ(scans_.all().at(1).observed->size(), 2U);
  EXPECT_EQ(scans_.all().at(1).observed->getObservationByClass<mrpt::obs::CObservation2DRangeScan>(), laser);
}

TEST_F(KeyframeScansTest, FramesThatAreNoKeyframesLeaveNothing) {
  scans_.onFrame(frame_, {});
  EXPECT_TRUE(scans_.all().empty());
}

TEST_F(KeyframeScansTest, KeyframesThatAreGivenUpTakeTheirScansAlong) {
  see(1);
  see(2);
  odometry::MapUpdate update;
  update.removedKeyframes.emplace_back();
  update.removedKeyframes.back().id = 1;
  scans_.onUpdate(update);
  EXPECT_EQ(scans_.all().count(1), 0U);
  EXPECT_EQ(scans_.all().count(2), 1U);
}

}  // namespace
}  // namespace wardslam::mrpt_slam
