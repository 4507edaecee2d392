#include "geometric_motion_filter.h"

#include <gmock/gmock.h>

#include "change/moving_scene.h"
#include "support/complaint.h"
#include "wardslam/core/errors.h"
#include "wardslam/filters/filter_chain.h"

namespace wardslam::filters {
namespace {

using change::test::kFrameTime_s;
using change::test::Scene;
using core::bitOf;
using core::Motion;
using core::PixelLabel;
using testing::HasSubstr;

class GeometricMotionFilterTest : public testing::Test {
 protected:
  GeometricMotionFilterTest() { scene_.add(change::test::person()); }

  void configure(const std::string& parameters) { filter_.initialize(core::ConfigNode::fromText(parameters), {}); }

  /// The last of so many images of a person walking by, seen by a camera that turns.
  core::Frame walk(double turn_rad_s = 0.0, double walk_m_s = 0.5, int images = 20) {
    core::Frame frame;
    for (int i = 0; i < images; ++i) {
      const double stamp_s = i * kFrameTime_s;
      frame =
          scene_.frame(stamp_s, change::test::looking({0, 0, 0}, turn_rad_s * (stamp_s - images * kFrameTime_s / 2)));
      if (prepare_) prepare_(frame);
      filter_.begin(frame);
      filter_.apply(frame);
      filter_.end(frame, std::nullopt);
      scene_.board(0).p_map_m.x() += walk_m_s * kFrameTime_s;
    }
    return frame;
  }

  Scene scene_;
  GeometricMotionFilter filter_;
  std::function<void(core::Frame&)> prepare_;
};

/// Shares of the key points marked, on the person (less than 2 m away) and beside him.
std::pair<double, double> markedShares(const core::Frame& frame) {
  int counts[2][2] = {{0, 0}, {0, 0}};
  for (const auto& keypoint : frame.features.keypoints) {
    ++counts[keypoint.depth_m < 2.0F][keypoint.motion == Motion::Dynamic];
  }
  return {double(counts[1][1]) / (counts[1][0] + counts[1][1]), double(counts[0][1]) / (counts[0][0] + counts[0][1])};
}

TEST_F(GeometricMotionFilterTest, MarksWhoWalksByWithoutMasks) {
  configure("{}");
  const core::Frame frame = walk();
  const auto [onPerson, beside] = markedShares(frame);
  EXPECT_GT(onPerson, 0.9);
  EXPECT_LT(beside, 0.05);
  EXPECT_EQ(frame.events.count("filters.motion_unknown"), 0U);
}

constexpr double kFast_rad_s = 1.5;  // 86 degrees a second: the image moves by 27 px from one to the next

TEST_F(GeometricMotionFilterTest, AFastTurnEatsNothingOfTheScene) {
  configure("{}");
  const auto [onPerson, beside] = markedShares(walk(kFast_rad_s, 0.0, 14));
  EXPECT_LT(onPerson, 0.01) << "who stands still";
  EXPECT_LT(beside, 0.01);
}

TEST_F(GeometricMotionFilterTest, MarksWhoWalksByWhileTheCameraTurnsFast) {
  configure("{}");
  const auto [onPerson, beside] = markedShares(walk(kFast_rad_s, 0.8, 14));
  EXPECT_GT(onPerson, 0.8);
  EXPECT_LT(beside, 0.05);
}

TEST_F(GeometricMotionFilterTest, TheFirstImageHasNothingToCompareWith) {
  configure("{}");
  const core::Frame frame = walk(0.0, 0.5, 1);
  EXPECT_EQ(markedShares(frame), std::make_pair(0.0, 0.0));
  EXPECT_TRUE(frame.events.empty()) << "which is no trouble";
}

TEST_F(GeometricMotionFilterTest, LabelsThePixels) {
  configure("{}");
  const core::Frame frame = walk();
  const cv::Mat dynamic = core::dynamicPixels(frame);
  const cv::Mat person = frame.depth_m < 2.0;
  EXPECT_GT(cv::countNonZero(dynamic & person), 0.9 * cv::countNonZero(person));
  EXPECT_EQ(frame.labelBits.at<std::uint8_t>(240, 600), 0);
  EXPECT_EQ(cv::countNonZero(frame.mayMove != dynamic), 0);
}

TEST_F(GeometricMotionFilterTest, AddsToWhatEarlierFiltersMarked) {
  configure("{}");
  constexpr std::uint8_t kDynamicPerson = bitOf(PixelLabel::Person) | bitOf(PixelLabel::Dynamic);
  prepare_ = [](core::Frame& frame) {
    cv::Mat bits(change::test::kHeight, change::test::kWidth, CV_8UC1, cv::Scalar(0));
    bits(cv::Rect(600, 0, 40, 480)).setTo(kDynamicPerson);
    core::addLabels(frame, bits);
    for (auto& keypoint : frame.features.keypoints) {
      if (keypoint.raw_px.x >= 600) keypoint.motion = Motion::Dynamic;
    }
  };
  const core::Frame frame = walk();
  EXPECT_EQ(frame.labelBits.at<std::uint8_t>(240, 620), kDynamicPerson);
  EXPECT_GT(cv::countNonZero(frame.labelBits.colRange(0, 600)), 0) << "and the person found";
  for (const auto& keypoint : frame.features.keypoints) {
    if (keypoint.raw_px.x >= 600) {
      EXPECT_EQ(keypoint.motion, Motion::Dynamic);
    }
  }
}

TEST_F(GeometricMotionFilterTest, LeavesTheOutlineOfWhoHasAMaskToTheMask) {
  configure("{}");
  cv::Mat person;
  prepare_ = [&person](core::Frame& frame) {
    person = frame.depth_m < 2.0;
    core::addDynamic(frame, person);
    for (auto& keypoint : frame.features.keypoints) {
      if (keypoint.depth_m < 2.0F) keypoint.motion = Motion::Dynamic;
    }
  };
  const core::Frame frame = walk();
  EXPECT_EQ(cv::norm(core::dynamicPixels(frame), person, cv::NORM_INF), 0.0);
}

TEST_F(GeometricMotionFilterTest, FindsWhatAMaskedPersonMovesAlong) {
  configure("{}");
  constexpr int kMaskFrom_px = 240;  // above that row the mask lacks what moves
  prepare_ = [](core::Frame& frame) {
    cv::Mat masked = frame.depth_m < 2.0;
    masked.rowRange(0, kMaskFrom_px).setTo(0);
    core::addDynamic(frame, masked);
    for (auto& keypoint : frame.features.keypoints) {
      if (keypoint.depth_m < 2.0F && keypoint.raw_px.y >= kMaskFrom_px) keypoint.motion = Motion::Dynamic;
    }
  };
  const core::Frame frame = walk();
  const cv::Rect above(0, 0, change::test::kWidth, kMaskFrom_px);
  const cv::Mat without = frame.depth_m(above) < 2.0;
  EXPECT_GT(cv::countNonZero(core::dynamicPixels(frame)(above) & without), 0.8 * cv::countNonZero(without));
  const auto [onPerson, beside] = markedShares(frame);
  EXPECT_GT(onPerson, 0.9);
  EXPECT_LT(beside, 0.05);
}

TEST_F(GeometricMotionFilterTest, DoesNotBelieveThatEverythingMoves) {
  configure("{min_kept: 0.9}");  // the person alone covers more than a tenth
  const core::Frame frame = walk();
  EXPECT_EQ(markedShares(frame).first, 0.0);
  EXPECT_EQ(frame.events.at("filters.motion_everywhere"), 1U);
}

TEST_F(GeometricMotionFilterTest, AFrameWithoutKeyPointsOrDepthIsNoTrouble) {
  configure("{}");
  prepare_ = [](core::Frame& frame) {
    frame.features = {};
    frame.depth_m.setTo(0);
  };
  EXPECT_EQ(walk().events.at("filters.motion_unknown"), 1U);
}

TEST(GeometricMotionFilterOptions, OutOfBoundsAreRefused) {
  const auto complaint = [](const std::string& parameters) -> std::string {
    return wardslam::test::complaintOf(
        [&] { GeometricMotionFilter().initialize(core::ConfigNode::fromText(parameters, "my.yaml"), {}); });
  };
  EXPECT_THAT(complaint("points: 10"), testing::AllOf(HasSubstr("my.yaml:1"), HasSubstr("points")));
  EXPECT_THAT(complaint("window: -1"), HasSubstr("window"));
  EXPECT_THAT(complaint("window: long"), HasSubstr("window"));
  EXPECT_THAT(complaint("reach: .nan"), HasSubstr("reach"));
  EXPECT_THAT(complaint("min_kept: 2"), HasSubstr("min_kept"));
  EXPECT_THAT(complaint("annotate: false"), testing::AllOf(HasSubstr("my.yaml:1"), HasSubstr("annotate"),
                                                           HasSubstr("at the top of the configuration")));
  EXPECT_EQ(complaint("{points: 50, window: 2.0}"), "");
}

TEST(GeometricMotionFilterChain, IsMadeByName) {
  const FilterChain chain(
      core::ConfigNode::fromText("[{class_name: 'wardslam::filters::GeometricMotionFilter', params: {window: 0.3}}]"),
      {});
  EXPECT_THAT(chain.parameters(0), HasSubstr("window: 0.3"));
  const auto wrong =
      core::ConfigNode::fromText("[{class_name: 'wardslam::filters::GeometricMotionFilter', params: {windw: 1}}]");
  EXPECT_THAT(wardslam::test::complaintOf([&] { FilterChain(wrong, {}); }), HasSubstr("did you mean 'window'"));
}

}  // namespace
}  // namespace wardslam::filters
