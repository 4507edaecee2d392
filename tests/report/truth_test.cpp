#include "truth.h"

#include <gmock/gmock.h>

#include "wardslam/core/errors.h"

namespace wardslam::report {
namespace {

/// Around a corner, a pose every 0.1 s.
core::Trajectory corner() {
  core::Trajectory way;
  for (int i = 0; i <= 20; ++i) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() << 0.1 * std::min(i, 10), 0.1 * std::max(i - 10, 0), 1.0;
    way.push_back({50.0 + 0.1 * i, pose});
  }
  return way;
}

TEST(Truth, IsLaidOverTheWay) {
  const auto estimate = corner();
  const Eigen::Isometry3d T_truth_map =
      Eigen::Translation3d(3.0, -2.0, 0.5) * Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitZ());
  core::Trajectory truth = estimate;
  for (auto& pose : truth) pose.T_map_cam = T_truth_map * pose.T_map_cam;
  truth.insert(truth.begin(), {10.0, Eigen::Isometry3d::Identity()});  // long before the run
  truth.push_back({90.0, Eigen::Isometry3d::Identity()});

  const Comparison comparison = compare(truth, estimate);
  ASSERT_EQ(comparison.truthInMap.size(), estimate.size());
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    EXPECT_TRUE(comparison.truthInMap[i].T_map_cam.isApprox(estimate[i].T_map_cam, 1e-9)) << i;
  }
  EXPECT_NEAR(comparison.ate.translation_m.rmse, 0.0, 1e-9);
}

TEST(Truth, OfAnotherTimeIsRefused) {
  auto truth = corner();
  for (auto& pose : truth) pose.stamp_s += 1000.0;
  EXPECT_THROW(compare(truth, corner()), core::InputError);
}

}  // namespace
}  // namespace wardslam::report
