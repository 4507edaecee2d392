#include "sensors/mishaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace wardslam::synth {
namespace {

TEST(Cover, IsReadFromItsTwoNumbers) {
  const Cover cover = parseCover("12.5:3");
  EXPECT_EQ(cover.from_s, 12.5);
  EXPECT_EQ(cover.seconds, 3.0);
  for (const char* wrong : {"", "12", "12:", ":3", "12:3:4", "12-3", "-1:3", "12:0", "12:3s", "nan:1"}) {
    EXPECT_THROW(static_cast<void>(parseCover(wrong)), std::invalid_argument) << wrong;
  }
}

TEST(Cover, ComesFromBelowAndGoesBack) {
  const std::vector<Cover> covers = {{2.0, 1.0}, {10.0, 0.5}};
  EXPECT_EQ(coveredShare(covers, 1.99), 0.0);
  EXPECT_NEAR(coveredShare(covers, 2.0 + kHand_s / 2), 0.5, 1e-9);
  EXPECT_EQ(coveredShare(covers, 2.5), 1.0);
  EXPECT_NEAR(coveredShare(covers, 3.0 - kHand_s / 3), 1.0 / 3, 1e-9);
  EXPECT_EQ(coveredShare(covers, 3.01), 0.0);
  EXPECT_EQ(coveredShare(covers, 10.25), 1.0);
  EXPECT_EQ(coveredShare({}, 10.25), 0.0);

  cv::Mat image(100, 10, CV_8UC3, cv::Scalar::all(200));
  coverColor(image, 0.25);
  EXPECT_EQ(image.at<cv::Vec3b>(74, 5), cv::Vec3b::all(200));
  EXPECT_LT(image.at<cv::Vec3b>(75, 5)[2], 20);
}

TEST(LostFrames, AreTheAskedShareAndComeInBursts) {
  const auto lost = lostFrames(100000, 0.1, 1);
  EXPECT_FALSE(lost.front());
  const auto count = static_cast<double>(std::count(lost.begin(), lost.end(), true));
  EXPECT_NEAR(count / 1e5, 0.1, 0.01);
  double bursts = 0;
  for (std::size_t i = 1; i < lost.size(); ++i) bursts += lost[i] && !lost[i - 1] ? 1 : 0;
  EXPECT_NEAR(count / bursts, kBurst, 0.15);
}

TEST(LostFrames, TheSeedDecides) {
  EXPECT_EQ(lostFrames(1000, 0.1, 1), lostFrames(1000, 0.1, 1));
  EXPECT_NE(lostFrames(1000, 0.1, 1), lostFrames(1000, 0.1, 2));
  EXPECT_EQ(lostFrames(1000, 0.0, 1), std::vector<bool>(1000, false));
}

}  // namespace
}  // namespace wardslam::synth
