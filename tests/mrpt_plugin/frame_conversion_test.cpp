#include "wardslam/mrpt_plugin/frame_conversion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include "hand_made_observation.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::mrpt_plugin {
namespace {

using ::testing::ElementsAre;

/// The frame that the hand-made observation tells of.
core::Frame handMadeFrame() {
  const auto o = handMadeObservation();
  core::Frame frame;
  frame.stamp_s = 1234567890.25;
  frame.camera = o.camera;
  frame.T_base_cam = core::fromMrpt(o.cameraPose) * core::T_sensor_cam();
  frame.gray = cv::Mat(48, 64, CV_8UC1, cv::Scalar(100));
  frame.segmentation = o.segmentation;
  frame.features = o.features;
  frame.observation = mrpt::obs::CObservation3DRangeScan::Create();
  frame.observation->sensorLabel = "RGBD";
  frame.observation->timestamp = core::toMrptTime(frame.stamp_s);
  frame.labelBits = o.labelBits;
  return frame;
}

TEST(FrameConversion, TellsWhatTheFiltersFoundOut) {
  const auto expected = handMadeObservation();
  const auto o = toObservation(handMadeFrame(), core::LabelSpace::coco(), 5);
  EXPECT_EQ(o->sensorLabel, "RGBD_SEM");
  EXPECT_EQ(o->timestamp, expected.timestamp);
  EXPECT_THAT(o->states, ElementsAre(KeypointState::Static, KeypointState::Movable, KeypointState::Dynamic,
                                     KeypointState::Static));
  EXPECT_EQ(o->classes, expected.classes);
  EXPECT_EQ(cv::countNonZero(o->labelBits != expected.labelBits), 0);
  EXPECT_LT((core::fromMrpt(o->cameraPose).matrix() - core::fromMrpt(expected.cameraPose).matrix()).norm(), 1e-12);
  EXPECT_EQ(o->descriptorSide, 5);
}

TEST(FrameConversion, WithoutLabelsNothingIsKnownToBeMovable) {
  core::Frame frame = handMadeFrame();
  frame.labelBits.release();
  const auto o = toObservation(frame, core::LabelSpace::coco());
  EXPECT_TRUE(o->labelBits.empty());
  EXPECT_THAT(o->states,
              ElementsAre(KeypointState::Static, KeypointState::Static, KeypointState::Dynamic, KeypointState::Static));
}

TEST(FrameConversion, ComesBackAsAFrame) {
  const core::Frame frame = handMadeFrame();
  const core::Frame back = toFrame(*toObservation(frame, core::LabelSpace::coco(), 5));
  EXPECT_DOUBLE_EQ(back.stamp_s, frame.stamp_s);
  EXPECT_TRUE(back.camera == frame.camera);
  EXPECT_TRUE(back.T_base_cam.isApprox(frame.T_base_cam, 1e-12));
  ASSERT_EQ(back.features.size(), frame.features.size());
  EXPECT_EQ(back.features.keypoints[1].raw_px, frame.features.keypoints[1].raw_px);
  EXPECT_EQ(back.features.keypoints[2].motion, core::Motion::Dynamic);
  EXPECT_EQ(cv::countNonZero(back.segmentation.instanceIds != frame.segmentation.instanceIds), 0);
  EXPECT_EQ(cv::countNonZero(back.mayMove), 20 * 48);
  ASSERT_TRUE(back.features.semanticDescriptors);
  EXPECT_EQ(back.features.semanticDescriptors->of(back.features.keypoints[2]), core::SemanticDescriptor(25, 1));
}

}  // namespace
}  // namespace wardslam::mrpt_plugin
