#include "wardslam/viewer/label_layout.h"

#include <gmock/gmock.h>

namespace wardslam::viewer {
namespace {

using ::testing::ElementsAre;

const cv::Size kPicture(200, 100);

TEST(LabelLayout, LeavesWhatDoesNotOverlap) {
  EXPECT_TRUE(movedApart({}, kPicture).empty());
  EXPECT_THAT(movedApart({{10, 10, 40, 12}, {50, 10, 40, 12}, {10, 22, 40, 12}}, kPicture),
              ElementsAre(cv::Rect(10, 10, 40, 12), cv::Rect(50, 10, 40, 12), cv::Rect(10, 22, 40, 12)));
}

TEST(LabelLayout, GoesToTheNearestFreePlace) {
  // A line up and a line down are 13 px away, the next place to the side 40 px: up comes first.
  EXPECT_THAT(movedApart({{50, 40, 40, 12}, {50, 40, 40, 12}, {50, 40, 40, 12}, {50, 40, 40, 12}}, kPicture),
              ElementsAre(cv::Rect(50, 40, 40, 12), cv::Rect(50, 27, 40, 12), cv::Rect(50, 53, 40, 12),
                          cv::Rect(50, 14, 40, 12)));
}

TEST(LabelLayout, KeepsLabelsInThePicture) {
  EXPECT_THAT(movedApart({{-20, -5, 40, 12}, {190, 95, 40, 12}}, kPicture),
              ElementsAre(cv::Rect(0, 0, 40, 12), cv::Rect(160, 88, 40, 12)));
  EXPECT_THAT(movedApart({{5, 5, 300, 12}}, kPicture), ElementsAre(cv::Rect(0, 5, 300, 12)));
}

TEST(LabelLayout, WhatFindsNoRoomStaysWhereItIsWanted) {
  EXPECT_THAT(movedApart({{0, 0, 40, 12}, {0, 0, 40, 12}}, cv::Size(40, 12)),
              ElementsAre(cv::Rect(0, 0, 40, 12), cv::Rect(0, 0, 40, 12)));
}

}  // namespace
}  // namespace wardslam::viewer
