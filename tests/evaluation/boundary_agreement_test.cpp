#include "boundary_agreement.h"

#include <gtest/gtest.h>

namespace wardslam::evaluation {
namespace {

/// 40×30 pixels, of which the rectangle belongs to the mask.
cv::Mat maskOf(const cv::Rect& box) {
  cv::Mat mask(30, 40, CV_8UC1, cv::Scalar(0));
  mask(box).setTo(7);  // anything but 0
  return mask;
}

TEST(CompareBoundaries, OfEqualMasksAreOne) {
  const auto boundary = compareBoundaries(maskOf({5, 5, 10, 10}), maskOf({5, 5, 10, 10}), 0);
  EXPECT_EQ(boundary.precision, 1.0);
  EXPECT_EQ(boundary.recall, 1.0);
  EXPECT_EQ(boundary.f, 1.0);
}

TEST(CompareBoundaries, CountTheShareOfOutlineWithinTheTolerance) {
  // Outlines of 36 pixels (10×10) and 66 (25×10). They share the left side, and 10 columns above and below: 28 pixels
  // (two columns of 10, less the right side of the smaller). Of the larger one those are 10 + 2·9.
  const cv::Mat small = maskOf({5, 5, 10, 10});
  const cv::Mat large = maskOf({5, 5, 25, 10});
  const auto exact = compareBoundaries(large, small, 0);
  EXPECT_DOUBLE_EQ(exact.recall, 28.0 / 36.0);     // 10 + 2·9: all but the 8 in the middle of the right side
  EXPECT_DOUBLE_EQ(exact.precision, 28.0 / 66.0);  // the same pixels
  EXPECT_DOUBLE_EQ(exact.f, 2 * 28.0 / (36.0 + 66.0));
  // Within 2 px: of the larger one, two columns more above and below; of the smaller, the 4 pixels of its right side
  // that lie 1 or 2 px from above or below.
  const auto near = compareBoundaries(large, small, 2);
  EXPECT_DOUBLE_EQ(near.precision, 32.0 / 66.0);
  EXPECT_DOUBLE_EQ(near.recall, 32.0 / 36.0);
}

TEST(CompareBoundaries, MeasureDistanceOnADisc) {
  // One pixel each, 3 columns and 4 rows apart: 5 px.
  EXPECT_EQ(compareBoundaries(maskOf({10, 10, 1, 1}), maskOf({13, 14, 1, 1}), 4).f, 0.0);
  EXPECT_EQ(compareBoundaries(maskOf({10, 10, 1, 1}), maskOf({13, 14, 1, 1}), 5).f, 1.0);
}

TEST(CompareBoundaries, TakeTheImageBorderForNoOutline) {
  // Only the right side of a mask that fills the left half is an outline; of one that fills the image, nothing.
  EXPECT_EQ(compareBoundaries(maskOf({0, 0, 20, 30}), maskOf({0, 0, 21, 30}), 1).f, 1.0);
  EXPECT_EQ(compareBoundaries(maskOf({0, 0, 20, 30}), maskOf({0, 0, 40, 30}), 1).f, 0.0);
}

TEST(CompareBoundaries, OfMasksWithoutOutlineAgree) {
  EXPECT_EQ(compareBoundaries(maskOf({}), maskOf({}), 3).f, 1.0);
  EXPECT_EQ(compareBoundaries(maskOf({5, 5, 10, 10}), maskOf({}), 3).f, 0.0);
  EXPECT_EQ(compareBoundaries(maskOf({}), maskOf({5, 5, 10, 10}), 3).f, 0.0);
}

TEST(DavisTolerance, GrowsWithTheImage) {
  EXPECT_EQ(davisTolerance_px({640, 480}), 6);  // 0.0075 · 800
  EXPECT_EQ(davisTolerance_px({1280, 960}), 12);
}

}  // namespace
}  // namespace wardslam::evaluation
