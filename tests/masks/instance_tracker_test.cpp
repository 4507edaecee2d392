#include "wardslam/masks/instance_tracker.h"

#include <gtest/gtest.h>

#include <set>

#include "masks/textured_scene.h"

namespace wardslam::masks {
namespace {

using namespace scene;

constexpr double kFrame_s = 0.1;

core::Segmentation masksOf(std::initializer_list<std::pair<core::ClassId, cv::Rect>> things) {
  Picture picture = wall(4.0);
  std::uint16_t id = 40;  // as a segmenter numbers them, without regard to the last image
  for (const auto& [classId, box] : things) put(picture, ++id, classId, box, 2.0);
  return picture.masks;
}

std::uint16_t idAt(const core::Segmentation& masks, cv::Point at) { return masks.instanceIds.at<std::uint16_t>(at); }

const core::Instance* find(const core::Segmentation& masks, std::uint16_t id) {
  for (const auto& instance : masks.instances) {
    if (instance.id == id) return &instance;
  }
  return nullptr;
}

/// Hands every result on as what was carried, which is right while nothing moves.
class InstanceTrackerTest : public testing::Test {
 protected:
  core::Segmentation& next(const core::Segmentation& detected) {
    last_ = tracker_.update(detected, last_, time_s_);
    time_s_ += kFrame_s;
    return last_;
  }

  static InstanceTrackerOptions bridging(double seconds) {
    InstanceTrackerOptions options;
    options.bridge_s = seconds;
    return options;
  }

  InstanceTracker tracker_{bridging(0.35)};
  core::Segmentation last_;
  double time_s_ = 100.0;
};

const cv::Rect kLeft(40, 60, 60, 110);
const cv::Rect kRight(180, 60, 60, 110);
const cv::Point kInLeft(60, 100);
const cv::Point kInRight(200, 100);

TEST_F(InstanceTrackerTest, KeepsIdentityWhateverTheOrder) {
  next(masksOf({{kPerson, kLeft}, {kPerson, kRight}}));
  const auto left = idAt(last_, kInLeft);
  const auto right = idAt(last_, kInRight);
  EXPECT_NE(left, 0);
  EXPECT_NE(right, 0);
  EXPECT_NE(left, right);
  const cv::Point step(6, 0);
  next(masksOf({{kPerson, kRight + step}, {kPerson, kLeft + step}}));
  EXPECT_EQ(idAt(last_, kInLeft), left);
  EXPECT_EQ(idAt(last_, kInRight), right);
  ASSERT_NE(find(last_, left), nullptr);
  EXPECT_EQ(find(last_, left)->box_px, kLeft + step);
  EXPECT_EQ(last_.instances.size(), 2U);
}

TEST_F(InstanceTrackerTest, TheBestOverlapWins) {
  next(masksOf({{kPerson, {40, 60, 60, 100}}}));
  const auto id = idAt(last_, kInLeft);
  // Two now overlap the one before: by 30 of 90 columns, and by 55 of 65.
  next(masksOf({{kPerson, {10, 60, 35, 100}}, {kPerson, {45, 60, 60, 100}}}));
  EXPECT_EQ(idAt(last_, kInLeft), id);
  EXPECT_NE(idAt(last_, {20, 100}), id);
}

TEST_F(InstanceTrackerTest, AnotherClassOrTooLittleOverlapIsAnotherThing) {
  next(masksOf({{kPerson, kLeft}, {kPerson, kRight}}));
  const auto left = idAt(last_, kInLeft);
  const auto right = idAt(last_, kInRight);
  next(masksOf({{kChair, kLeft}, {kPerson, kRight + cv::Point(40, 0)}}));  // overlap 20 of 100 columns
  EXPECT_NE(idAt(last_, kInLeft), left);
  EXPECT_NE(idAt(last_, {225, 100}), right);
}

TEST_F(InstanceTrackerTest, WhatIsMissedStaysAndFades) {
  for (int i = 0; i < 5; ++i) next(masksOf({{kPerson, kLeft}, {kChair, kRight}}));  // seen for 0.4 s
  const auto id = idAt(last_, kInLeft);
  float confidence = 0.9F;
  for (int i = 1; i <= 3; ++i) {  // missed for up to 0.3 s
    next(masksOf({{kChair, kRight}}));
    ASSERT_NE(find(last_, id), nullptr) << i;
    EXPECT_EQ(cv::countNonZero(last_.instanceIds == id), kLeft.area());
    EXPECT_EQ(last_.classIds.at<core::ClassId>(kInLeft), kPerson);
    EXPECT_LT(find(last_, id)->confidence, confidence);
    confidence = find(last_, id)->confidence;
  }
  EXPECT_NEAR(confidence, 0.9 * std::pow(0.25, 0.3 / 0.35), 1e-4);
  next(masksOf({{kChair, kRight}}));
  EXPECT_EQ(find(last_, id), nullptr) << "0.4 s are too long";
  EXPECT_EQ(idAt(last_, kInLeft), 0);
}

TEST_F(InstanceTrackerTest, FoundAgainItIsTheSame) {
  for (int i = 0; i < 4; ++i) next(masksOf({{kPerson, kLeft}}));
  const auto id = idAt(last_, kInLeft);
  next(masksOf({}));
  next(masksOf({{kPerson, kLeft}}));
  EXPECT_EQ(idAt(last_, kInLeft), id);
  EXPECT_EQ(find(last_, id)->confidence, 0.9F);
  for (int i = 0; i < 3; ++i) next(masksOf({}));
  EXPECT_NE(find(last_, id), nullptr) << "its time began anew";
}

TEST_F(InstanceTrackerTest, StaysNoLongerThanItWasSeen) {
  next(masksOf({{kPerson, kLeft}}));
  next(masksOf({}));
  EXPECT_TRUE(last_.instances.empty()) << "a single sighting may be an error";
  next(masksOf({{kPerson, kLeft}}));
  next(masksOf({{kPerson, kLeft}}));  // seen for 0.1 s
  next(masksOf({}));
  EXPECT_EQ(last_.instances.size(), 1U);
  next(masksOf({}));
  EXPECT_TRUE(last_.instances.empty());
}

TEST_F(InstanceTrackerTest, DetectionsComeFirst) {
  for (int i = 0; i < 4; ++i) next(masksOf({{kPerson, kLeft}}));
  const auto id = idAt(last_, kInLeft);
  next(masksOf({{kChair, {40, 60, 20, 110}}}));  // a third of it
  EXPECT_EQ(last_.classIds.at<core::ClassId>(100, 50), kChair);
  ASSERT_NE(find(last_, id), nullptr);
  EXPECT_EQ(find(last_, id)->box_px, cv::Rect(60, 60, 40, 110)) << "what is left of it";
  next(masksOf({{kChair, {40, 60, 42, 110}}}));  // and more than half of the rest
  EXPECT_EQ(find(last_, id), nullptr);
}

TEST_F(InstanceTrackerTest, BridgesNothingWhenToldSo) {
  tracker_ = InstanceTracker(bridging(0.0));
  for (int i = 0; i < 4; ++i) next(masksOf({{kPerson, kLeft}}));
  const auto id = idAt(last_, kInLeft);
  next(masksOf({{kPerson, kLeft}}));
  EXPECT_EQ(idAt(last_, kInLeft), id) << "identity is kept all the same";
  next(masksOf({}));
  EXPECT_TRUE(last_.instances.empty());
}

TEST_F(InstanceTrackerTest, AnImageThatCouldNotBeSegmentedIsBridgedToo) {
  for (int i = 0; i < 4; ++i) next(masksOf({{kPerson, kLeft}}));
  next({});
  EXPECT_EQ(last_.instances.size(), 1U);
  EXPECT_EQ(cv::countNonZero(last_.classIds == kPerson), kLeft.area());
}

TEST_F(InstanceTrackerTest, NoMasksAndNothingKeptIsNoSegmentation) {
  EXPECT_TRUE(next({}).empty());
  EXPECT_FALSE(next(masksOf({})).empty()) << "segmented, and nothing there";
  EXPECT_TRUE(next({}).empty());
}

TEST_F(InstanceTrackerTest, WithoutInstancesRegionsAreTheThings) {
  core::Segmentation detected = masksOf({{kPerson, kLeft}, {kPerson, kRight}});
  detected.instances.clear();
  detected.instanceIds.release();
  next(detected);
  ASSERT_EQ(last_.instances.size(), 2U);
  const auto left = idAt(last_, kInLeft);
  EXPECT_NE(left, idAt(last_, kInRight));
  next(detected);
  EXPECT_EQ(idAt(last_, kInLeft), left);
}

TEST_F(InstanceTrackerTest, LeavesItsArgumentsAlone) {
  const core::Segmentation detected = masksOf({{kPerson, kLeft}});
  next(detected);
  last_.classIds.setTo(9);
  last_.instanceIds.setTo(9);
  EXPECT_EQ(idAt(detected, kInLeft), 41);
  EXPECT_EQ(detected.classIds.at<core::ClassId>(kInLeft), kPerson);
}

TEST_F(InstanceTrackerTest, IdsComeRoundAfterManyThings) {
  // Two that stay, and one that is new every time: more things than there are ids.
  const cv::Size size(4, 1);
  InstanceTracker tracker(bridging(0.0));
  core::Segmentation carried;
  std::set<std::uint16_t> lasting;
  for (int i = 0; i < 70'000; ++i) {
    core::Segmentation detected{cv::Mat(size, CV_8UC1, cv::Scalar(kChair)), cv::Mat(size, CV_16UC1), {}};
    detected.classIds.at<core::ClassId>(2) = i % 2 == 0 ? kPerson : kChair;
    for (int x = 0; x < 3; ++x) {
      const auto id = static_cast<std::uint16_t>(x + 1);
      detected.instanceIds.at<std::uint16_t>(x) = id;
      detected.instances.push_back({id, detected.classIds.at<core::ClassId>(x), 1.0F, {x, 0, 1, 1}});
    }
    detected.instanceIds.at<std::uint16_t>(3) = 0;
    carried = tracker.update(detected, carried, i);
    const auto* ids = carried.instanceIds.ptr<std::uint16_t>();
    lasting.insert({ids[0], ids[1]});
    ASSERT_TRUE(ids[2] != 0 && lasting.count(ids[2]) == 0) << i;
  }
  EXPECT_EQ(lasting.size(), 2U);
}

}  // namespace
}  // namespace wardslam::masks
