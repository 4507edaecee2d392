#include "wardslam/filters/annotation.h"

#include <gmock/gmock.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <memory>
#include <utility>
#include <vector>

#include "change/moving_scene.h"
#include "filters/ward_fixture.h"
#include "wardslam/core/annotation.h"
#include "wardslam/filters/filter_chain.h"

namespace wardslam::filters {
namespace {

using mrpt::obs::CObservation3DRangeScan;

std::shared_ptr<CObservation3DRangeScan> scanOf(const cv::Size& size) {
  auto scan = CObservation3DRangeScan::Create();
  scan->hasRangeImage = true;
  scan->rangeImage_setSize(size.height, size.width);
  return scan;
}

/// A frame of 5x3 pixels in which one moves.
core::Frame frameWith(std::shared_ptr<CObservation3DRangeScan> observation) {
  core::Frame frame;
  frame.observation = std::move(observation);
  cv::Mat mask(3, 5, CV_8UC1, cv::Scalar(0));
  mask.at<std::uint8_t>(1, 4) = 255;
  core::addDynamic(frame, mask);
  return frame;
}

TEST(AnnotateObservation, WritesWhatTheFiltersFound) {
  core::Frame frame = frameWith(scanOf({5, 3}));
  annotateObservation(frame);
  EXPECT_EQ(cv::countNonZero(core::annotationOf(*frame.observation) != frame.labelBits), 0);
  EXPECT_EQ(frame.observation->confidenceImage.asCvMatRef().at<std::uint8_t>(1, 4), 0);
  EXPECT_TRUE(frame.events.empty());
}

TEST(AnnotateObservation, LeavesOneOfAnotherSizeAsItIsAndCountsIt) {
  core::Frame frame = frameWith(scanOf({10, 6}));
  annotateObservation(frame);
  EXPECT_FALSE(frame.observation->hasPixelLabels());
  EXPECT_EQ(frame.events.at("filters.annotation_size"), 1U);
}

TEST(AnnotateObservation, NeedsSomethingToWriteAndSomewhereToWriteIt) {
  core::Frame nowhere = frameWith(nullptr);
  annotateObservation(nowhere);
  EXPECT_TRUE(nowhere.events.empty());
  core::Frame nothing;
  nothing.observation = scanOf({5, 3});
  annotateObservation(nothing);
  EXPECT_FALSE(nothing.observation->hasPixelLabels());
  EXPECT_TRUE(nothing.events.empty());
}

/// What the default chain marks in the last of twenty images of somebody with a mask walking by, when
/// observations have range images of this size (0 = there are no observations).
core::Frame walkBy(const cv::Size& rangeSize) {
  auto masks = std::make_shared<segmentation::Segmenter::Result>();
  FilterChain chain(core::ConfigNode::fromText("[{class_name: 'wardslam::filters::SemanticDynamicFilter'}, "
                                               "{class_name: 'wardslam::filters::GeometricMotionFilter'}]"),
                    ward::context(masks));
  change::test::Scene scene;
  scene.add(change::test::person());
  core::Frame frame;
  for (int i = 0; i < 20; ++i) {
    frame = scene.frame(i * change::test::kFrameTime_s, Eigen::Vector3d::Zero());
    if (!rangeSize.empty()) frame.observation = scanOf(rangeSize);
    masks->segmentation.classIds = (frame.depth_m < 2.0F) & ward::kPerson;
    chain.begin(frame);
    chain.apply(frame);
    annotateObservation(frame);
    chain.end(frame, Eigen::Isometry3d::Identity());
    scene.board(0).p_map_m.x() += 0.5 * change::test::kFrameTime_s;
  }
  return frame;
}

std::vector<std::pair<core::Motion, float>> marksOf(const core::Frame& frame) {
  std::vector<std::pair<core::Motion, float>> marks;
  for (const auto& keypoint : frame.features.keypoints) marks.emplace_back(keypoint.motion, keypoint.staticProbability);
  return marks;
}

TEST(AnnotateObservation, WhatIsMarkedDoesNotDependOnTheObservation) {
  const core::Frame whole = walkBy({change::test::kWidth, change::test::kHeight});
  ASSERT_TRUE(whole.observation->hasPixelLabels());
  ASSERT_GT(cv::countNonZero(core::dynamicPixels(whole)), 0);
  for (const cv::Size& size : {cv::Size(), cv::Size(10, 10)}) {
    const core::Frame other = walkBy(size);
    EXPECT_EQ(marksOf(other), marksOf(whole)) << size;
    EXPECT_EQ(cv::countNonZero(other.labelBits != whole.labelBits), 0) << size;
    EXPECT_EQ(cv::countNonZero(other.mayMove != whole.mayMove), 0) << size;
  }
}

}  // namespace
}  // namespace wardslam::filters
