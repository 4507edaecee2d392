#include "depth_instances.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <opencv2/core.hpp>

#include "wardslam/core/segmentation.h"

namespace wardslam::segmentation {
namespace {

constexpr core::ClassId kPerson = 1;
constexpr core::ClassId kBed = 60;
constexpr DepthLabelling kOptions{260.0, 25, kPerson};

/// A wall at 4 m, and things before it.
class DepthInstances : public ::testing::Test {
 protected:
  void put(const cv::Rect& box, core::ClassId classId, float depth_m) {
    classIds_(box).setTo(classId);
    depth_m_(box).setTo(depth_m);
  }
  int label() {
    ids_ = labelByDepth(classIds_, depth_m_, kOptions);
    double most = 0.0;
    cv::minMaxLoc(ids_, nullptr, &most);
    return static_cast<int>(most);
  }
  [[nodiscard]] int at(int x, int y) const { return ids_.at<std::uint16_t>(y, x); }

  cv::Mat classIds_ = cv::Mat(60, 80, CV_8UC1, cv::Scalar(0));
  cv::Mat depth_m_ = cv::Mat(60, 80, CV_32FC1, cv::Scalar(4.0));
  cv::Mat ids_;
};

TEST_F(DepthInstances, AreSplitWherePeopleTouchAtDifferentDepths) {
  put({10, 10, 20, 40}, kPerson, 2.0F);
  put({30, 10, 20, 40}, kPerson, 2.6F);
  EXPECT_EQ(label(), 2);
  EXPECT_NE(at(29, 30), at(30, 30));
  EXPECT_EQ(at(11, 30), at(29, 30));
}

TEST_F(DepthInstances, ABedsFrameBehindItsMattressIsNoOtherBed) {
  put({10, 10, 20, 40}, kBed, 2.0F);
  put({30, 10, 20, 40}, kBed, 2.6F);
  EXPECT_EQ(label(), 1);
  put({30, 10, 20, 40}, kBed, 3.0F);
  EXPECT_EQ(label(), 2);
}

TEST_F(DepthInstances, AreOneWhereDepthDoesNotTell) {
  put({10, 10, 20, 40}, kPerson, 2.0F);
  put({30, 10, 20, 40}, kPerson, 2.1F);
  EXPECT_EQ(label(), 1);
}

TEST_F(DepthInstances, ASurfaceThatGoesAwayStaysWhole) {
  for (int x = 5; x < 75; ++x) put({x, 20, 1, 20}, kBed, 1.5F + 0.03F * static_cast<float>(x));
  EXPECT_EQ(label(), 1);
}

TEST_F(DepthInstances, ABedBehindAnArmIsOne) {
  put({5, 20, 70, 20}, kBed, 2.0F);
  put({35, 0, 8, 60}, kPerson, 1.2F);
  EXPECT_EQ(label(), 2);
  EXPECT_EQ(at(10, 30), at(70, 30));
  EXPECT_NE(at(10, 30), at(38, 30));
}

TEST_F(DepthInstances, WhatIsSeenBetweenTwoThingsTellsThemApart) {
  put({5, 20, 30, 20}, kBed, 2.0F);
  put({43, 20, 30, 20}, kBed, 2.0F);  // the wall in between is farther away
  EXPECT_EQ(label(), 2);
  EXPECT_NE(at(10, 30), at(70, 30));
}

TEST_F(DepthInstances, FarApartBehindSomethingWideTheyAreTwo) {
  put({0, 20, 5, 20}, kBed, 2.0F);
  put({5, 0, 70, 60}, kPerson, 1.2F);
  put({75, 20, 5, 20}, kBed, 2.0F);  // 70 px at 2 m are 0.54 m
  EXPECT_EQ(label(), 3);
}

TEST_F(DepthInstances, AtAnotherDepthBehindAnArmTheyAreTwo) {
  put({5, 20, 30, 20}, kBed, 2.0F);
  put({43, 20, 30, 20}, kBed, 3.0F);
  put({35, 0, 8, 60}, kPerson, 1.2F);
  EXPECT_EQ(label(), 3);
  EXPECT_NE(at(10, 30), at(70, 30));
}

TEST_F(DepthInstances, AShadowInAThingBelongsToIt) {
  put({10, 10, 40, 40}, kPerson, 2.0F);
  depth_m_(cv::Rect(28, 10, 4, 40)).setTo(0.0F);
  depth_m_(cv::Rect(40, 20, 1, 1)).setTo(3.5F);  // a stray pixel, too
  EXPECT_EQ(label(), 1);
  EXPECT_EQ(cv::countNonZero(ids_), 40 * 40);
}

TEST_F(DepthInstances, WithoutAnyDepthRegionsCount) {
  put({10, 10, 20, 40}, kPerson, 0.0F);
  put({50, 10, 20, 40}, kPerson, 0.0F);
  EXPECT_EQ(label(), 2);
}

TEST_F(DepthInstances, ScrapsAreNone) {
  put({10, 10, 4, 6}, kPerson, 2.0F);
  EXPECT_EQ(label(), 0);
  put({10, 10, 5, 5}, kPerson, 2.0F);
  EXPECT_EQ(label(), 1);
}

TEST_F(DepthInstances, ReadsPartsOfLargerImages) {
  put({10, 10, 20, 40}, kPerson, 2.0F);
  const cv::Rect part(5, 5, 40, 50);
  EXPECT_EQ(cv::countNonZero(labelByDepth(classIds_(part), depth_m_(part), kOptions)), 20 * 40);
}

}  // namespace
}  // namespace wardslam::segmentation
