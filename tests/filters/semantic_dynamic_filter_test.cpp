#include "semantic_dynamic_filter.h"

#include <gmock/gmock.h>

#include "change/depth_scene.h"
#include "filters/ward_fixture.h"
#include "support/complaint.h"
#include "wardslam/core/errors.h"

namespace wardslam::filters {
namespace {

using core::bitOf;
using core::Motion;
using core::PixelLabel;
using segmentation::Segmenter;
using namespace ward;

constexpr int kWidth = 80;
constexpr int kHeight = 60;
constexpr const char* kSmallSquare = "{rule: paper, n: 5, delta: 4, margin_px: 0}";

void put(core::Segmentation& segmentation, core::ClassId c, cv::Rect box) {
  const auto id = static_cast<std::uint16_t>(segmentation.instances.size() + 1);
  segmentation.classIds(box).setTo(c);
  segmentation.instanceIds(box).setTo(id);
  segmentation.instances.push_back({id, c, 0.9F, box});
}

/// A person (columns 20–39) holds a cup (40–43), a chair stands beside (50–69), and a bed below all of it.
Segmenter::Result wardScene() {
  Segmenter::Result result;
  result.segmentation.classIds = cv::Mat(kHeight, kWidth, CV_8UC1, cv::Scalar(0));
  result.segmentation.instanceIds = cv::Mat(kHeight, kWidth, CV_16UC1, cv::Scalar(0));
  put(result.segmentation, kPerson, {20, 10, 20, 30});
  put(result.segmentation, kCup, {40, 20, 4, 5});
  put(result.segmentation, kChair, {50, 10, 20, 20});
  put(result.segmentation, kBed, {0, 40, kWidth, 20});
  return result;
}

core::Frame frameOf(std::vector<core::Keypoint> keypoints) {
  core::Frame frame;
  frame.stamp_s = 7.0;
  frame.color_bgr = cv::Mat(kHeight, kWidth, CV_8UC3, cv::Scalar::all(100));
  frame.gray = cv::Mat(kHeight, kWidth, CV_8UC1, cv::Scalar(100));
  frame.features.keypoints = std::move(keypoints);
  return frame;
}

class SemanticDynamicFilterTest : public testing::Test {
 protected:
  void configure(const std::string& parameters) {
    filter_.initialize(core::ConfigNode::fromText(parameters), context(result_));
  }

  core::Frame run(std::vector<core::Keypoint> keypoints) {
    core::Frame frame = frameOf(std::move(keypoints));
    filter_.begin(frame);
    filter_.apply(frame);
    return frame;
  }

  std::shared_ptr<Segmenter::Result> result_ = std::make_shared<Segmenter::Result>(wardScene());
  SemanticDynamicFilter filter_;
};

int labelsAt(const core::Frame& frame, int x, int y) {
  return frame.labelBits.empty() ? -1 : frame.labelBits.at<std::uint8_t>(y, x);
}

bool isDynamicAt(const core::Frame& frame, int x, int y) {
  return core::dynamicPixels(frame).at<std::uint8_t>(y, x) != 0;
}

TEST_F(SemanticDynamicFilterTest, MarksPeopleAndWhatTheyHold) {
  configure(kSmallSquare);
  const core::Frame frame =
      run({keypointAt(30, 20), keypointAt(41, 22), keypointAt(60, 20), keypointAt(30, 41), keypointAt(75, 5)});
  const auto& keypoints = frame.features.keypoints;
  EXPECT_EQ(keypoints[0].motion, Motion::Dynamic) << "person";
  EXPECT_EQ(keypoints[1].motion, Motion::Dynamic) << "cup in the hand";
  EXPECT_EQ(keypoints[2].motion, Motion::Static) << "chair ten pixels away";
  EXPECT_EQ(keypoints[3].motion, Motion::Static) << "bed below the person";
  EXPECT_EQ(keypoints[4].motion, Motion::Static) << "background";
}

TEST_F(SemanticDynamicFilterTest, HandsTheSegmentationAndItsEventsOn) {
  configure(kSmallSquare);
  result_->events["fake.trouble"] = 2;
  const core::Frame frame = run({});
  EXPECT_EQ(frame.segmentation.instances.size(), 4U);
  EXPECT_EQ(cv::countNonZero(frame.segmentation.classIds != result_->segmentation.classIds), 0);
  EXPECT_THAT(frame.events,
              testing::UnorderedElementsAre(testing::Pair("fake.trouble", 2), testing::Pair("fake.stamp_7", 1)));
}

TEST_F(SemanticDynamicFilterTest, AppliesWithoutABeginToo) {
  configure(kSmallSquare);
  for (int i = 0; i < 2; ++i) {
    core::Frame frame = frameOf({keypointAt(30, 20)});
    filter_.apply(frame);
    EXPECT_EQ(frame.features.keypoints[0].motion, Motion::Dynamic);
  }
}

TEST_F(SemanticDynamicFilterTest, AMarginWidensPeopleOnly) {
  const std::vector<core::Keypoint> around = {keypointAt(17, 20), keypointAt(16, 20), keypointAt(30, 42),
                                              keypointAt(30, 43), keypointAt(42, 22), keypointAt(48, 20)};
  configure("{rule: paper, n: 5, delta: 24, margin_px: 3}");
  const auto keypoints = run(around).features.keypoints;
  EXPECT_EQ(keypoints[0].motion, Motion::Dynamic) << "three pixels left of the person";
  EXPECT_EQ(keypoints[1].motion, Motion::Static) << "four pixels left";
  EXPECT_EQ(keypoints[2].motion, Motion::Dynamic) << "on the bed, three pixels below the person";
  EXPECT_EQ(keypoints[3].motion, Motion::Static);
  EXPECT_EQ(keypoints[4].motion, Motion::Dynamic) << "on the cup, within the margin";
  EXPECT_EQ(keypoints[5].motion, Motion::Static) << "chairs are not widened";

  configure("{rule: paper, n: 5, delta: 24, margin_px: 0}");
  for (const auto& keypoint : run(around).features.keypoints) EXPECT_EQ(keypoint.motion, Motion::Static);
}

TEST_F(SemanticDynamicFilterTest, AMarginLeavesEachMoverItsOwnPixels) {
  // A dog (the higher id) beside the person must not grow over him: it could not move the cup he holds.
  put(result_->segmentation, kDog, {36, 10, 4, 30});
  configure("{rule: paper, n: 3, delta: 2, margin_px: 2}");
  EXPECT_EQ(run({keypointAt(43, 22)}).features.keypoints[0].motion, Motion::Static)
      << "beside the dog, widened to column 41";
  result_->segmentation.classIds(cv::Rect(36, 10, 4, 30)).setTo(kPerson);
  EXPECT_EQ(run({keypointAt(42, 22)}).features.keypoints[0].motion, Motion::Dynamic);
}

TEST_F(SemanticDynamicFilterTest, LabelsPixelsByMeaning) {
  configure(kSmallSquare);
  const core::Frame frame = run({});
  const int person = bitOf(PixelLabel::Person);
  const int dynamic = bitOf(PixelLabel::Dynamic);
  const int thing = bitOf(PixelLabel::Thing);
  const int movable = bitOf(PixelLabel::Movable);
  EXPECT_EQ(labelsAt(frame, 30, 20), person | dynamic);
  EXPECT_EQ(labelsAt(frame, 41, 22), thing | movable | dynamic) << "cup in the hand";
  EXPECT_EQ(labelsAt(frame, 43, 24), thing | movable) << "its far end";
  EXPECT_EQ(labelsAt(frame, 60, 20), thing | movable) << "chair nobody touches";
  EXPECT_EQ(labelsAt(frame, 30, 50), thing) << "bed";
  EXPECT_EQ(labelsAt(frame, 5, 5), 0);
}

TEST_F(SemanticDynamicFilterTest, LabelsNothingElseAsDynamic) {
  configure(kSmallSquare);
  const core::Frame frame = run({});
  ASSERT_EQ(frame.labelBits.size(), cv::Size(kWidth, kHeight));
  EXPECT_EQ(cv::countNonZero(core::dynamicPixels(frame)), 20 * 30 + 2 * 5) << "the person and half of the cup";
}

TEST_F(SemanticDynamicFilterTest, AddsToWhatEarlierFiltersLabelled) {
  configure(kSmallSquare);
  core::Frame frame = frameOf({});
  cv::Mat mask(kHeight, kWidth, CV_8UC1, cv::Scalar(0));
  mask.at<std::uint8_t>(50, 30) = 255;
  core::addDynamic(frame, mask);
  filter_.apply(frame);
  EXPECT_EQ(labelsAt(frame, 30, 50), bitOf(PixelLabel::Thing) | bitOf(PixelLabel::Dynamic)) << "bed";
  EXPECT_EQ(labelsAt(frame, 31, 50), bitOf(PixelLabel::Thing));
}

TEST_F(SemanticDynamicFilterTest, ByThePapersRulePixelsAreDynamicAsKeyPointsAre) {
  configure("{rule: paper, n: 5, delta: 6, margin_px: 0}");
  std::vector<core::Keypoint> everywhere;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) everywhere.push_back(keypointAt(static_cast<float>(x), static_cast<float>(y)));
  }
  const core::Frame frame = run(everywhere);
  for (const auto& keypoint : frame.features.keypoints) {
    const auto [x, y] = std::pair(static_cast<int>(keypoint.raw_px.x), static_cast<int>(keypoint.raw_px.y));
    EXPECT_EQ(isDynamicAt(frame, x, y), keypoint.motion == Motion::Dynamic) << x << ", " << y;
  }
  EXPECT_TRUE(isDynamicAt(frame, 40, 22)) << "ten pixels of the person in the square";
  EXPECT_FALSE(isDynamicAt(frame, 41, 22)) << "five of them";
}

TEST_F(SemanticDynamicFilterTest, ThingsTooSmallForAnInstanceAreLeftToThePapersRule) {
  configure("{rule: observed, n: 5, delta: 4, margin_px: 0}");
  result_->segmentation.instances.clear();
  result_->segmentation.instanceIds.release();
  const core::Frame frame = run({keypointAt(41, 22), keypointAt(60, 20)});
  EXPECT_EQ(frame.features.keypoints[0].motion, Motion::Dynamic);
  EXPECT_EQ(frame.features.keypoints[1].motion, Motion::Static);
}

/// The same ward with depth: a wall 3 m away, a person at 2 m, and a chair beside him.
class ObservedRule : public SemanticDynamicFilterTest {
 protected:
  ObservedRule() {
    scene_.add({1, kPerson, {-0.5, 0.0, 2.0}, 0.4, 1.2});
    scene_.add({2, kChair, {0.0, 0.0, 2.0}, 0.6, 0.5});
    configure("{rule: observed, n: 21, delta: 55, margin_px: 0}");
  }

  /// So many images of the chair at this speed (m/s); the last one, with key points on the near and the far end of it.
  core::Frame watch(int images, double speed) {
    core::Frame frame;
    for (int i = 0; i < images; ++i) {
      frame = scene_.frame(time_s_);
      result_->segmentation = frame.segmentation;
      frame.segmentation = {};
      frame.color_bgr = cv::Mat(frame.gray.size(), CV_8UC3, cv::Scalar::all(0));
      const auto& chair = result_->segmentation.instances[1].box_px;
      const auto middle = static_cast<float>(chair.y + chair.height / 2);
      frame.features.keypoints = {keypointAt(static_cast<float>(chair.x + 1), middle),
                                  keypointAt(static_cast<float>(chair.br().x - 2), middle),
                                  keypointAt(static_cast<float>(result_->segmentation.instances[0].box_px.x), middle)};
      filter_.apply(frame);
      filter_.end(frame, Eigen::Isometry3d::Identity());
      time_s_ += change::test::kFrameTime_s;
      scene_.thing(0).p_map_m.x() += speed * change::test::kFrameTime_s;
      scene_.thing(1).p_map_m.x() += speed * change::test::kFrameTime_s;
    }
    return frame;
  }

  static std::vector<Motion> motions(const core::Frame& frame) {
    std::vector<Motion> result;
    for (const auto& keypoint : frame.features.keypoints) result.push_back(keypoint.motion);
    return result;
  }

  change::test::DepthScene scene_;
  double time_s_ = 1.0;
};

TEST_F(ObservedRule, AtFirstItIsCautiousNearThePerson) {
  EXPECT_THAT(motions(watch(1, 0.0)), testing::ElementsAre(Motion::Dynamic, Motion::Static, Motion::Dynamic));
}

TEST_F(ObservedRule, AChairThatStaysHelpsSoon) {
  EXPECT_THAT(motions(watch(25, 0.0)), testing::ElementsAre(Motion::Static, Motion::Static, Motion::Dynamic));
}

TEST_F(ObservedRule, WhatMightMoveWeighsLess) {
  const auto helps = watch(25, 0.0).features.keypoints.front().staticProbability;
  EXPECT_GT(helps, 0.7F);
  EXPECT_LT(helps, 1.0F);
  core::Frame frame = scene_.frame(time_s_);
  frame.segmentation = {};
  frame.features.keypoints = {keypointAt(1, 1)};
  filter_.apply(frame);
  EXPECT_EQ(frame.features.keypoints.front().staticProbability, 1.0F) << "the wall";
}

TEST_F(ObservedRule, DoesNotMakeSurerWhatAnEarlierFilterDoubts) {
  watch(25, 0.0);
  core::Frame frame = scene_.frame(time_s_);
  frame.segmentation = {};
  frame.features.keypoints = {keypointAt(1, 1)};
  frame.features.keypoints.front().staticProbability = 0.25F;
  filter_.apply(frame);
  EXPECT_EQ(frame.features.keypoints.front().staticProbability, 0.25F) << "the wall";
}

TEST_F(ObservedRule, AChairThatIsPushedGoesAsAWhole) {
  EXPECT_THAT(motions(watch(18, 0.4)), testing::ElementsAre(Motion::Dynamic, Motion::Dynamic, Motion::Dynamic));
}

TEST_F(ObservedRule, WhatMovesIsWidened) {
  configure("{rule: observed, margin_px: 3}");
  const cv::Rect chair = watch(18, 0.4).segmentation.instances[1].box_px;
  core::Frame frame = scene_.frame(time_s_);
  result_->segmentation = frame.segmentation;
  const cv::Rect now = result_->segmentation.instances[1].box_px;
  ASSERT_GT(now.x, chair.x - 1);
  frame.segmentation = {};
  const auto y = static_cast<float>(now.y + 20);
  const auto right = static_cast<float>(now.br().x - 1);
  frame.features.keypoints = {keypointAt(right + 3, y), keypointAt(right + 4, y)};
  filter_.apply(frame);
  EXPECT_THAT(motions(frame), testing::ElementsAre(Motion::Dynamic, Motion::Static));
}

TEST_F(SemanticDynamicFilterTest, SaysWhereAnnotateWent) {
  const auto text = core::ConfigNode::fromText("{n: 5, annotate: false}", "my.yaml");
  EXPECT_THAT(wardslam::test::complaintOf([&] { filter_.initialize(text, context(result_)); }),
              testing::AllOf(testing::HasSubstr("my.yaml:1"), testing::HasSubstr("'annotate'"),
                             testing::HasSubstr("at the top of the configuration")));
}

TEST_F(SemanticDynamicFilterTest, WithoutMasksAllStaysStaticAndIsCounted) {
  configure(kSmallSquare);
  *result_ = {};
  const core::Frame frame = run({keypointAt(30, 20)});
  EXPECT_EQ(frame.features.keypoints[0].motion, Motion::Static);
  EXPECT_EQ(frame.events.at("filters.no_segmentation"), 1U);
  EXPECT_EQ(labelsAt(frame, 30, 20), -1);
}

TEST_F(SemanticDynamicFilterTest, MasksOfAnotherSizeCountAsNone) {
  configure(kSmallSquare);
  result_->segmentation.classIds = cv::Mat(10, 10, CV_8UC1, cv::Scalar(kPerson));
  const core::Frame frame = run({keypointAt(5, 5)});
  EXPECT_EQ(frame.features.keypoints[0].motion, Motion::Static);
  EXPECT_TRUE(frame.segmentation.empty());
  EXPECT_EQ(frame.events.at("filters.segmentation_size"), 1U);
  EXPECT_EQ(frame.events.at("filters.no_segmentation"), 1U);
}

TEST_F(SemanticDynamicFilterTest, PropagationGetsItsMasksLater) {
  configure("{mode: propagate, latency_frames: 2, rule: paper, n: 5, delta: 4, margin_px: 0}");
  for (std::uint64_t i = 0; i < 4; ++i) {
    core::Frame frame = frameOf({keypointAt(30, 20)});
    frame.index = i;
    filter_.apply(frame);
    EXPECT_EQ(frame.features.keypoints[0].motion, Motion::Dynamic);
    EXPECT_EQ(frame.segmentationAge_frames, i == 3 ? 2 : i);
  }
}

TEST_F(SemanticDynamicFilterTest, ADeterministicRunTakesNoMasksByChance) {
  FilterContext repeatable = context(result_);
  repeatable.deterministic = true;
  for (const char* parameters : {"{mode: wait}", "{mode: propagate, latency_frames: 1}"}) {
    SemanticDynamicFilter filter;
    EXPECT_NO_THROW(filter.initialize(core::ConfigNode::fromText(parameters), repeatable));
  }
  const auto text = core::ConfigNode::fromText("{mode: propagate}", "my.yaml");
  EXPECT_THAT(wardslam::test::complaintOf([&] { filter_.initialize(text, repeatable); }),
              testing::AllOf(testing::HasSubstr("my.yaml"), testing::HasSubstr("latency_frames")));
}

TEST_F(SemanticDynamicFilterTest, ABoxBeyondTheImageIsCut) {
  configure(kSmallSquare);
  result_->segmentation.instances[1].box_px = {-10, -10, 1000, 1000};
  EXPECT_EQ(labelsAt(run({}), 30, 20), bitOf(PixelLabel::Person) | bitOf(PixelLabel::Dynamic));
}

}  // namespace
}  // namespace wardslam::filters
