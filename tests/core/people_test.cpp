#include "wardslam/core/people.h"

#include <gtest/gtest.h>

namespace wardslam::core {
namespace {

constexpr int kSide_px = 60;

cv::Mat labelsWith(PixelLabel label, const cv::Rect& area) {
  cv::Mat labels(kSide_px, kSide_px, CV_8UC1, cv::Scalar(0));
  labels(area).setTo(bitOf(label));
  return labels;
}

TEST(People, ArePeopleAndWhatMovesAndAMarginAround) {
  for (const PixelLabel label : {PixelLabel::Person, PixelLabel::Dynamic}) {
    const cv::Mat people = peoplePixels(labelsWith(label, {20, 20, 10, 10}));
    cv::Mat expected(kSide_px, kSide_px, CV_8UC1, cv::Scalar(0));
    expected(cv::Rect(12, 12, 26, 26)).setTo(255);
    EXPECT_EQ(cv::norm(people, expected, cv::NORM_INF), 0.0);
  }
  EXPECT_EQ(cv::countNonZero(peoplePixels(labelsWith(PixelLabel::Thing, {20, 20, 10, 10}))), 0);
}

TEST(People, MayBeAnywhereWhereNobodyLookedForThem) {
  Frame frame;
  frame.gray = cv::Mat(kSide_px, kSide_px, CV_8UC1, cv::Scalar(90));
  frame.labelBits = labelsWith(PixelLabel::Dynamic, {20, 20, 10, 10});
  EXPECT_EQ(cv::countNonZero(peoplePixels(frame)), kSide_px * kSide_px);
  frame.segmentation.classIds = cv::Mat(kSide_px, kSide_px, CV_8UC1, cv::Scalar(0));
  EXPECT_EQ(cv::countNonZero(peoplePixels(frame)), 26 * 26);
}

TEST(People, AreBlankedInACopy) {
  const cv::Mat image(kSide_px, kSide_px, CV_8UC3, cv::Scalar(1, 2, 3));
  cv::Mat people(kSide_px / 2, kSide_px / 2, CV_8UC1, cv::Scalar(0));
  people.at<std::uint8_t>(5, 7) = 255;  // of an image half as large
  const cv::Mat picture = blanked(image, people);
  EXPECT_EQ(picture.at<cv::Vec3b>(11, 15), cv::Vec3b(128, 128, 128));
  EXPECT_EQ(picture.at<cv::Vec3b>(11, 16), cv::Vec3b(1, 2, 3));
  EXPECT_EQ(image.at<cv::Vec3b>(11, 15), cv::Vec3b(1, 2, 3));
}

}  // namespace
}  // namespace wardslam::core
