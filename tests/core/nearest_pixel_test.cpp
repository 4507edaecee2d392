#include "wardslam/core/nearest_pixel.h"

#include <gtest/gtest.h>

namespace wardslam::core {
namespace {

const cv::Size kSize(640, 480);

TEST(NearestPixel, IsTheOneWhoseCentreIsNearest) { EXPECT_EQ(nearestPixel({10.4F, 20.6F}, kSize), cv::Point(10, 21)); }

TEST(NearestPixel, LiesInTheImage) {
  EXPECT_EQ(nearestPixel({-3.0F, 5.0F}, kSize), cv::Point(0, 5));
  EXPECT_EQ(nearestPixel({639.7F, 480.2F}, kSize), cv::Point(639, 479));
}

}  // namespace
}  // namespace wardslam::core
