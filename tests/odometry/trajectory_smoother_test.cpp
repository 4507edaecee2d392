#include "wardslam/odometry/trajectory_smoother.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace wardslam::odometry {
namespace {

constexpr double kImage_s = 1.0 / 30.0;

PoseCovariance sigmas(double translation_m, double rotation_rad) {
  PoseCovariance covariance = PoseCovariance::Zero();
  covariance.diagonal().head<3>().setConstant(translation_m * translation_m);
  covariance.diagonal().tail<3>().setConstant(rotation_rad * rotation_rad);
  return covariance;
}

/// A camera that goes along x and turns to the left, both evenly.
Eigen::Isometry3d evenly(double stamp_s, double speed_mps = 0.5, double turn_radps = 0.4) {
  return Eigen::Translation3d(speed_mps * stamp_s, 1.0, 0.0) *
         Eigen::Isometry3d(Eigen::AngleAxisd(turn_radps * stamp_s, Eigen::Vector3d::UnitZ()));
}

std::vector<EstimatedPose> evenWay(int images, const PoseCovariance& covariance) {
  std::vector<EstimatedPose> poses;
  for (int i = 0; i < images; ++i) poses.push_back({i * kImage_s, evenly(i * kImage_s), covariance, true});
  return poses;
}

double length_m(const core::Trajectory& trajectory) {
  double length = 0.0;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    length += (trajectory[i].T_map_cam.translation() - trajectory[i - 1].T_map_cam.translation()).norm();
  }
  return length;
}

double rms_m(const core::Trajectory& trajectory) {
  double sum = 0.0;
  for (const auto& pose : trajectory) {
    sum += (pose.T_map_cam.translation() - evenly(pose.stamp_s).translation()).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(trajectory.size()));
}

/// Of `sigma_m` in each direction.
void disturb(std::vector<EstimatedPose>& poses, double sigma_m) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, sigma_m);
  for (auto& pose : poses) pose.T_map_cam.translation() += Eigen::Vector3d(noise(random), noise(random), noise(random));
}

TEST(TrajectorySmoother, LeavesAWayThatIsEven) {
  const auto way = evenWay(90, sigmas(0.003, 0.001));
  const auto trajectory = smoothed(way, {});
  ASSERT_EQ(trajectory.size(), way.size());
  for (std::size_t i = 0; i < way.size(); ++i) {
    EXPECT_EQ(trajectory[i].stamp_s, way[i].stamp_s);
    EXPECT_TRUE(trajectory[i].T_map_cam.isApprox(way[i].T_map_cam, 1e-6)) << i;
    EXPECT_FALSE(trajectory[i].isBridged);
  }
}

TEST(TrajectorySmoother, TakesNoiseOfSingleImagesOutOfAWay) {
  auto way = evenWay(300, sigmas(0.003, 0.001));
  disturb(way, 0.003);
  const double truth_m = length_m(smoothed(evenWay(300, sigmas(0.003, 0.001)), {}));
  SmoothingOptions none;
  none.velocity_change_mps = 0.0;
  const auto raw = smoothed(way, none);
  const auto trajectory = smoothed(way, {});
  EXPECT_GT(length_m(raw), 1.04 * truth_m);
  EXPECT_LT(length_m(trajectory), 1.01 * truth_m);
  EXPECT_LT(rms_m(trajectory), 0.65 * rms_m(raw));
}

/// Of three poses the middle one is off by d. (e1^2 + e2^2 + e3^2) / s^2 + (e1 - 2 (d + e2) + e3)^2 / (T^2 q), where
/// q = change^2 * 2 T / 3, is least at e = (1, -2, 1) * 2 d s^2 / (6 s^2 + T^2 q).
TEST(TrajectorySmoother, MovesAPoseByAsMuchAsItIsUnsureAndTheCameraSlow) {
  const double T_s = 0.1;
  const double sigma_m = 0.01;
  const double off_m = 0.003;
  SmoothingOptions options;
  options.velocity_change_mps = 0.5;
  std::vector<EstimatedPose> way;
  for (int i = 0; i < 3; ++i) {
    way.push_back({i * T_s, Eigen::Isometry3d::Identity(), sigmas(sigma_m, 0.001), true});
  }
  way[1].T_map_cam.translation().x() = off_m;
  const auto trajectory = smoothed(way, options);
  const double s2 = sigma_m * sigma_m + options.least_sigma_m * options.least_sigma_m;
  const double q = options.velocity_change_mps * options.velocity_change_mps * 2.0 * T_s / 3.0;
  const double moved_m = 4.0 * off_m * s2 / (6.0 * s2 + T_s * T_s * q);
  EXPECT_NEAR(trajectory[1].T_map_cam.translation().x(), off_m - moved_m, 1e-5);
  EXPECT_NEAR(trajectory[0].T_map_cam.translation().x(), 0.5 * moved_m, 1e-5);
}

/// The same of turns about one axis.
TEST(TrajectorySmoother, TurnsAPoseByAsMuchAsItIsUnsureAndTheCameraSlow) {
  const double T_s = 0.1;
  const double sigma_rad = 0.01;
  const double off_rad = 0.003;
  SmoothingOptions options;
  options.turn_change_radps = 0.5;
  std::vector<EstimatedPose> way;
  for (int i = 0; i < 3; ++i) {
    const double angle_rad = i == 1 ? off_rad : 0.0;
    way.push_back({i * T_s, evenly(1.0, 0.0, angle_rad), sigmas(0.001, sigma_rad), true});
  }
  const auto trajectory = smoothed(way, options);
  const double s2 = sigma_rad * sigma_rad;
  const double q = options.turn_change_radps * options.turn_change_radps * 2.0 * T_s / 3.0;
  const double turned_rad = 4.0 * off_rad * s2 / (6.0 * s2 + T_s * T_s * q);
  EXPECT_NEAR(Eigen::AngleAxisd(trajectory[1].T_map_cam.linear()).angle(), off_rad - turned_rad, 1e-5);
  EXPECT_NEAR(Eigen::AngleAxisd(trajectory[0].T_map_cam.linear()).angle(), 0.5 * turned_rad, 1e-5);
}

TEST(TrajectorySmoother, LeadsThroughWhatIsKnown) {
  auto way = evenWay(60, sigmas(0.003, 0.001));
  way[30].T_map_cam.translation().y() += 0.02;
  way[30].covariance.reset();
  const auto trajectory = smoothed(way, {});
  EXPECT_TRUE(trajectory[30].T_map_cam.isApprox(way[30].T_map_cam, 1e-12));
  EXPECT_GT(trajectory[29].T_map_cam.translation().y(), 1.005) << "and what is beside it goes along";
}

TEST(TrajectorySmoother, BelievesWhatIsSure) {
  SmoothingOptions options;
  options.least_sigma_m = 0.0;
  auto way = evenWay(60, sigmas(0.003, 0.001));
  way[30].T_map_cam.translation().y() += 0.02;
  way[30].covariance = sigmas(1e-5, 1e-5);
  const auto trajectory = smoothed(way, options);
  EXPECT_NEAR(trajectory[30].T_map_cam.translation().y(), 1.02, 0.001);
  way[30].covariance = sigmas(0.05, 0.01);
  EXPECT_NEAR(smoothed(way, options)[30].T_map_cam.translation().y(), 1.0, 0.001);
}

TEST(TrajectorySmoother, BridgesImagesInWhichNothingWasSeen) {
  auto way = evenWay(90, sigmas(0.003, 0.001));
  for (std::size_t i = 40; i < 60; ++i) way[i] = {way[i].stamp_s, {}, {}, false};
  const auto trajectory = smoothed(way, {});
  ASSERT_EQ(trajectory.size(), way.size());
  for (std::size_t i = 0; i < way.size(); ++i) {
    EXPECT_EQ(trajectory[i].isBridged, i >= 40 && i < 60) << i;
    EXPECT_TRUE(trajectory[i].T_map_cam.isApprox(evenly(way[i].stamp_s), 1e-4)) << i;
  }
}

TEST(TrajectorySmoother, GoesOnABridgeAsTheCameraWentBeforeAndAfter) {
  std::vector<EstimatedPose> way;  // a bow, with a radius of a metre
  const auto onBow = [](double stamp_s) {
    return Eigen::Isometry3d(Eigen::AngleAxisd(0.5 * stamp_s, Eigen::Vector3d::UnitZ())) *
           Eigen::Isometry3d(Eigen::Translation3d(0, -1.0, 0));
  };
  for (int i = 0; i < 90; ++i) {
    const bool isSeen = i < 30 || i >= 60;
    way.push_back({i * kImage_s, isSeen ? onBow(i * kImage_s) : Eigen::Isometry3d::Identity(), {}, isSeen});
  }
  const auto trajectory = smoothed(way, {});
  ASSERT_EQ(trajectory.size(), 90U);
  // Straight on it would be off by 1 - cos(0.25) = 31 mm.
  EXPECT_LT((trajectory[45].T_map_cam.translation() - onBow(45 * kImage_s).translation()).norm(), 0.008);
}

TEST(TrajectorySmoother, MotionsThatWereMeasuredLeadOverABridge) {
  auto way = evenWay(90, sigmas(0.003, 0.001));
  for (std::size_t i = 40; i < 60; ++i) {
    way[i].isSeen = false;
    way[i].covariance = sigmas(0.01, 0.01);
    way[i].T_map_cam.translation().y() +=
        0.1 * std::sin(M_PI * static_cast<double>(i - 39) / 21.0);  // around something
  }
  const auto trajectory = smoothed(way, {});
  EXPECT_TRUE(trajectory[50].isBridged);
  EXPECT_GT(trajectory[50].T_map_cam.translation().y(), 1.07);
}

TEST(TrajectorySmoother, BridgesNothingLongNorAtTheEnds) {
  auto way = evenWay(120, sigmas(0.003, 0.001));
  for (std::size_t i = 0; i < 5; ++i) way[i].isSeen = false;
  for (std::size_t i = 40; i < 90; ++i) way[i] = {way[i].stamp_s, {}, {}, false};  // 51 / 30 s
  for (std::size_t i = 115; i < 120; ++i) way[i].isSeen = false;
  const auto trajectory = smoothed(way, {});
  ASSERT_EQ(trajectory.size(), 120U - 5U - 50U - 5U);
  for (const auto& pose : trajectory) EXPECT_FALSE(pose.isBridged);
  SmoothingOptions longer;
  longer.longest_bridge_s = 2.0;
  EXPECT_EQ(smoothed(way, longer).size(), 110U);
  longer.longest_bridge_s = 0.0;
  EXPECT_EQ(smoothed(way, longer).size(), 60U);
}

TEST(TrajectorySmoother, TwoStretchesHaveNothingToDoWithEachOther) {
  auto way = evenWay(60, sigmas(0.003, 0.001));
  for (std::size_t i = 30; i < 60; ++i) {
    way[i].stamp_s += 10.0;
    way[i].T_map_cam.translation().x() += 3.0;
  }
  const auto trajectory = smoothed(way, {});
  for (std::size_t i = 0; i < 60; ++i) EXPECT_TRUE(trajectory[i].T_map_cam.isApprox(way[i].T_map_cam, 1e-6)) << i;
}

/// The way around the seam, which is then in the middle of a part, is the same.
TEST(TrajectorySmoother, ALongWayIsSolvedInPartsThatMeet) {
  auto way = evenWay(2300, sigmas(0.003, 0.001));
  disturb(way, 0.003);
  const auto trajectory = smoothed(way, {});
  ASSERT_EQ(trajectory.size(), 2300U);
  const auto part = smoothed({way.begin() + 600, way.begin() + 1400}, {});
  for (std::size_t i = 900; i < 1100; ++i) {
    const Eigen::Vector3d difference = trajectory[i].T_map_cam.translation() - part[i - 600].T_map_cam.translation();
    EXPECT_LT(difference.norm(), 1e-5) << i;
  }
}

TEST(TrajectorySmoother, TakesWhatIsShortOrEqualInTime) {
  EXPECT_TRUE(smoothed({}, {}).empty());
  EXPECT_TRUE(smoothed({{1.0, {}, {}, false}}, {}).empty());
  const auto one = smoothed({{1.0, evenly(1.0), {}, true}}, {});
  ASSERT_EQ(one.size(), 1U);
  EXPECT_TRUE(one[0].T_map_cam.isApprox(evenly(1.0)));
  const auto three =
      smoothed({{1.0, evenly(1.0), {}, true}, {1.0, evenly(1.0), {}, true}, {1.0, evenly(1.0), {}, true}}, {});
  ASSERT_EQ(three.size(), 3U);
  for (const auto& pose : three) EXPECT_TRUE(pose.T_map_cam.matrix().allFinite());
}

}  // namespace
}  // namespace wardslam::odometry
