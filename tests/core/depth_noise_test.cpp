#include "wardslam/core/depth_noise.h"

#include <gtest/gtest.h>

namespace wardslam::core {
namespace {

TEST(DepthNoise, IsAKinectsByDefault) {
  EXPECT_NEAR(DepthNoise().sigma_m(0.4), 0.0012, 1e-12);
  EXPECT_NEAR(DepthNoise().sigma_m(1.4), 0.0031, 1e-12);
  EXPECT_NEAR(DepthNoise().sigma_m(4.4), 0.0316, 1e-12);
}

TEST(DepthNoise, OfAStereoCameraGrowsWithTheSquareOfTheDepth) {
  const DepthNoise stereo{0.0, 0.005, 0.0};
  EXPECT_NEAR(stereo.sigma_m(2.0), 0.02, 1e-12);
  EXPECT_NEAR(stereo.sigma_m(4.0), 0.08, 1e-12);
}

}  // namespace
}  // namespace wardslam::core
