#include "wardslam/odometry/keypoint_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace wardslam::odometry {
namespace {

std::vector<std::size_t> near(const KeypointGrid& grid, const Eigen::Vector2d& px, double radius_px) {
  std::vector<std::size_t> found;
  grid.forEachNear(px, radius_px, [&](std::size_t index) { found.push_back(index); });
  std::sort(found.begin(), found.end());
  return found;
}

TEST(KeypointGrid, FindsWhatLookingAtAllFinds) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> x_px(-60.0F, 700.0F);  // undistorted pixels may lie outside the image
  std::uniform_real_distribution<float> y_px(-60.0F, 540.0F);
  std::vector<core::Keypoint> keypoints(2000);
  for (auto& keypoint : keypoints) keypoint.undistorted_px = {x_px(random), y_px(random)};
  const KeypointGrid grid(keypoints, {});

  for (const double radius_px : {0.5, 4.0, 15.0, 60.0, 1000.0}) {
    for (int i = 0; i < 50; ++i) {
      const Eigen::Vector2d px(static_cast<double>(x_px(random)), static_cast<double>(y_px(random)));
      std::vector<std::size_t> expected;
      for (std::size_t k = 0; k < keypoints.size(); ++k) {
        const auto& at = keypoints[k].undistorted_px;
        if (std::hypot(static_cast<double>(at.x) - px.x(), static_cast<double>(at.y) - px.y()) <= radius_px) {
          expected.push_back(k);
        }
      }
      EXPECT_EQ(near(grid, px, radius_px), expected) << px.transpose() << " within " << radius_px;
    }
  }
}

TEST(KeypointGrid, UsesTheUndistortedPixel) {
  core::Keypoint keypoint;
  keypoint.raw_px = {10, 10};
  keypoint.undistorted_px = {300, 200};
  const std::vector<core::Keypoint> keypoints = {keypoint};
  const KeypointGrid grid(keypoints, {});
  EXPECT_EQ(near(grid, {300, 200}, 1).size(), 1U);
  EXPECT_EQ(near(grid, {10, 10}, 1).size(), 0U);
}

TEST(KeypointGrid, WithoutKeypointsFindsNone) {
  const std::vector<core::Keypoint> none;
  EXPECT_EQ(near(KeypointGrid(none, {}), {320, 240}, 1000).size(), 0U);
}

}  // namespace
}  // namespace wardslam::odometry
