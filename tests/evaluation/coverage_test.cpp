#include "wardslam/evaluation/coverage.h"

#include <gtest/gtest.h>

namespace wardslam::evaluation {
namespace {

/// Ten poses a second from `begin_s` to `end_s`.
void addPoses(core::Trajectory& trajectory, int begin_s, int end_s) {
  for (int i = 10 * begin_s; i <= 10 * end_s; ++i) trajectory.push_back({i / 10.0, Eigen::Isometry3d::Identity()});
}

TEST(Coverage, OfACompleteRunIsOne) {
  core::Trajectory trajectory;
  addPoses(trajectory, 0, 10);
  EXPECT_NEAR(coverage(trajectory, 0, 10), 1.0, 1e-12);
  EXPECT_NEAR(coverage(trajectory, 2, 8), 1.0, 1e-12) << "poses outside the recording do not count";
}

TEST(Coverage, LosesWhatIsMissingAtBothEndsAndInBetween) {
  core::Trajectory trajectory;
  addPoses(trajectory, 1, 3);
  addPoses(trajectory, 5, 9);
  EXPECT_NEAR(coverage(trajectory, 0, 10), (2.0 + 4.0) / 10.0, 1e-12);
}

TEST(Coverage, ShortGapsAreNoHoles) {
  const auto pose = Eigen::Isometry3d::Identity();
  EXPECT_NEAR(coverage({{0.0, pose}, {0.1875, pose}, {1.0, pose}}, 0.0, 1.0), 0.1875, 1e-12);
}

TEST(Coverage, OfNothingIsZero) {
  EXPECT_EQ(coverage({}, 0, 10), 0.0);
  EXPECT_EQ(coverage({{5.0, Eigen::Isometry3d::Identity()}}, 0, 10), 0.0);
  EXPECT_EQ(coverage({{5.0, Eigen::Isometry3d::Identity()}}, 5, 5), 0.0);
}

}  // namespace
}  // namespace wardslam::evaluation
