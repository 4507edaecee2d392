#include "wardslam/viewer/annotated_picture.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

namespace wardslam::viewer {
namespace {

/// Grey, with a person in columns 100..199 and a chair in columns 400..499, rows 100..299.
core::Frame frameWithPersonAndChair() {
  core::Frame frame;
  frame.color_bgr = cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(128));
  frame.segmentation.classIds = cv::Mat::zeros(480, 640, CV_8UC1);
  frame.segmentation.instanceIds = cv::Mat::zeros(480, 640, CV_16UC1);
  const auto add = [&](std::uint16_t id, core::ClassId classId, float confidence, const cv::Rect& box) {
    frame.segmentation.classIds(box).setTo(classId);
    frame.segmentation.instanceIds(box).setTo(id);
    frame.segmentation.instances.push_back({id, classId, confidence, box});
  };
  add(7, 1, 0.87F, {100, 100, 100, 200});
  add(300, 57, 1.0F, {400, 100, 100, 200});
  return frame;
}

void addKeypoint(core::Frame& frame, const cv::Point2f& raw_px, core::Motion motion) {
  core::Keypoint keypoint;
  keypoint.raw_px = raw_px;
  keypoint.motion = motion;
  frame.features.keypoints.push_back(keypoint);
}

cv::Vec3b at(const cv::Mat& picture, int x, int y) { return picture.at<cv::Vec3b>(y, x); }
bool isRed(const cv::Vec3b& bgr) { return bgr[2] > 150 && bgr[1] < 110 && bgr[0] < 110; }
bool isGreen(const cv::Vec3b& bgr) { return bgr[1] > 150 && bgr[2] < 130 && bgr[0] < 130; }
int changed(const cv::Mat& a, const cv::Mat& b) {
  cv::Mat difference;
  cv::absdiff(a, b, difference);
  return cv::countNonZero(difference.reshape(1));
}

TEST(AnnotatedPicture, LeavesTheFrameAlone) {
  core::Frame frame = frameWithPersonAndChair();
  const cv::Mat before = frame.color_bgr.clone();
  const cv::Mat picture = drawAnnotated(frame, core::LabelSpace::coco());
  EXPECT_EQ(changed(before, frame.color_bgr), 0);
  EXPECT_EQ(picture.size(), frame.color_bgr.size());
  EXPECT_EQ(picture.type(), CV_8UC3);
}

TEST(AnnotatedPicture, KeyPointsAreGreenWhenStaticAndRedWhenDynamic) {
  core::Frame frame = frameWithPersonAndChair();
  addKeypoint(frame, {300.0F, 50.0F}, core::Motion::Static);
  addKeypoint(frame, {320.0F, 50.0F}, core::Motion::Dynamic);
  const cv::Mat picture = drawAnnotated(frame, core::LabelSpace::coco());
  EXPECT_TRUE(isGreen(at(picture, 300, 50)));
  EXPECT_TRUE(isRed(at(picture, 320, 50)));
  EXPECT_EQ(at(picture, 310, 50), cv::Vec3b(128, 128, 128));
}

TEST(AnnotatedPicture, WhatMovesIsRedAndWhatStandsIsNot) {
  core::Frame frame = frameWithPersonAndChair();
  for (const float y : {120.0F, 140.0F, 160.0F}) {
    addKeypoint(frame, {150.0F, y}, core::Motion::Dynamic);
    addKeypoint(frame, {450.0F, y}, core::Motion::Static);
  }
  const cv::Mat picture = drawAnnotated(frame, core::LabelSpace::coco());
  const cv::Vec3b person = at(picture, 150, 250);
  EXPECT_GT(person[2], person[0] + 60);
  EXPECT_GT(person[2], person[1] + 60);
  const cv::Vec3b chair = at(picture, 450, 250);
  EXPECT_NE(chair, cv::Vec3b(128, 128, 128));
  EXPECT_LT(chair[2], std::max(chair[0], chair[1]) + 30);

  // The same chair, carried away.
  for (auto& keypoint : frame.features.keypoints) keypoint.motion = core::Motion::Dynamic;
  const cv::Vec3b carried = at(drawAnnotated(frame, core::LabelSpace::coco()), 450, 250);
  EXPECT_GT(carried[2], carried[0] + 60);
}

TEST(AnnotatedPicture, TagsTellNameAndConfidence) {
  core::Frame frame = frameWithPersonAndChair();
  const core::LabelSpace labels = core::LabelSpace::coco();
  const cv::Mat picture = drawAnnotated(frame, labels);
  const cv::Rect personTag(101, 101, 90, 14);
  frame.segmentation.instances[0].confidence = 0.42F;
  EXPECT_GT(changed(picture(personTag), drawAnnotated(frame, labels)(personTag)), 0);
  frame.segmentation.instances[0].confidence = 0.87F;
  frame.segmentation.instances[0].classId = 200;  // without a name
  EXPECT_GT(changed(picture(personTag), drawAnnotated(frame, labels)(personTag)), 0);
}

TEST(AnnotatedPicture, TheLegendCounts) {
  core::Frame frame = frameWithPersonAndChair();
  const core::LabelSpace labels = core::LabelSpace::coco();
  const cv::Rect legend(0, 430, 200, 50);
  addKeypoint(frame, {300.0F, 50.0F}, core::Motion::Static);
  const cv::Mat one = drawAnnotated(frame, labels);
  addKeypoint(frame, {300.0F, 60.0F}, core::Motion::Static);
  EXPECT_GT(changed(one(legend), drawAnnotated(frame, labels)(legend)), 0);
}

TEST(AnnotatedPicture, DrawsFramesWithoutSegmentation) {
  core::Frame frame;
  frame.color_bgr = cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(90));
  addKeypoint(frame, {300.0F, 50.0F}, core::Motion::Static);
  EXPECT_TRUE(isGreen(at(drawAnnotated(frame, core::LabelSpace::coco()), 300, 50)));
}

TEST(AnnotatedPicture, SurvivesThingsAtTheBorderAndTinyPictures) {
  core::Frame frame = frameWithPersonAndChair();
  frame.segmentation.instances[0].box_px = {-20, 470, 300, 40};
  frame.segmentation.instances[1].box_px = {700, 10, 50, 50};
  addKeypoint(frame, {-3.0F, 500.0F}, core::Motion::Dynamic);
  EXPECT_NO_THROW((void)drawAnnotated(frame, core::LabelSpace::coco()));

  core::Frame tiny;
  tiny.color_bgr = cv::Mat(16, 16, CV_8UC3, cv::Scalar::all(90));
  EXPECT_EQ(drawAnnotated(tiny, core::LabelSpace::coco()).size(), cv::Size(16, 16));
}

TEST(AnnotatedPicture, EqualFramesGiveEqualPictures) {
  const core::Frame frame = frameWithPersonAndChair();
  const core::LabelSpace labels = core::LabelSpace::coco();
  EXPECT_EQ(changed(drawAnnotated(frame, labels), drawAnnotated(frame, labels)), 0);
}

}  // namespace
}  // namespace wardslam::viewer
