#include "free_fan.h"

#include <gtest/gtest.h>

#include <limits>

#include "wardslam/core/mrpt_compat.h"

namespace wardslam::mapping {
namespace {

constexpr double kEye_m = 1.0;
constexpr double kWall_m = 3.0;

core::CameraModel camera() { return {}; }

/// Level, looking along x.
Eigen::Isometry3d T_map_cam() { return Eigen::Translation3d(0, 0, kEye_m) * core::T_sensor_cam(); }

StandingGround assumed() { return {core::GroundPlane::atZero(T_map_cam()), false}; }
StandingGround seen() { return {core::GroundPlane::atZero(T_map_cam()), true}; }

/// What a camera at T sees of a floor that is `height_m(x)` high, before a wall across the x axis: found by stepping
/// along each ray.
template <class Height>
cv::Mat lookAlong(const Height& height_m, double wall_m) {
  cv::Mat depth_m(480, 640, CV_32FC1, cv::Scalar(0));
  depth_m.forEach<float>([&](float& value, const int* at) {
    if (at[0] % 4 != 0 || at[1] % 4 != 0) return;  // the others are not looked at
    const Eigen::Vector3d ray = core::T_sensor_cam().linear() * camera().unproject({at[1], at[0]}, 1.0);
    for (double depth = 0.5; depth < 9.0; depth += 0.002) {
      const Eigen::Vector3d p = Eigen::Vector3d(0, 0, kEye_m) + depth * ray;
      if (p.z() > height_m(p.x()) && p.x() < wall_m) continue;
      value = static_cast<float>(depth);
      return;
    }
  });
  return depth_m;
}

/// Floor, a wall across the x axis, and a box of 0.4 m height at x = 2 m between y = 0.5 and 1 m.
cv::Mat lookAtWall() {
  cv::Mat depth_m(480, 640, CV_32FC1);
  depth_m.forEach<float>([](float& value, const int* at) {
    const Eigen::Vector3d ray = core::T_sensor_cam().linear() * camera().unproject({at[1], at[0]}, 1.0);
    double depth = kWall_m / ray.x();
    if (ray.z() < 0) depth = std::min(depth, -kEye_m / ray.z());
    const Eigen::Vector3d atBox = 2.0 / ray.x() * ray;
    if (atBox.y() > 0.5 && atBox.y() < 1.0 && atBox.z() + kEye_m > 0 && atBox.z() + kEye_m < 0.4) {
      depth = std::min(depth, 2.0 / ray.x());
    }
    value = static_cast<float>(depth);
  });
  return depth_m;
}

/// The end point of a fan in the direction of y / x, as x in the map.
double reach_m(const std::vector<Eigen::Vector3f>& fan_cam_m, double slope) {
  double nearest = 1e9;
  double x_m = -1;
  for (const auto& end_cam_m : fan_cam_m) {
    const Eigen::Vector3d end = T_map_cam() * end_cam_m.cast<double>();
    const double miss = std::abs(end.y() / end.x() - slope);
    if (miss < nearest) {
      nearest = miss;
      x_m = end.x();
    }
  }
  return x_m;
}

TEST(FreeFan, ReachesToWhatIsInTheWay) {
  const auto fan = freeFan(lookAtWall(), camera(), assumed(), {});
  EXPECT_NEAR(reach_m(fan, 0.0), kWall_m, 0.01);
  EXPECT_NEAR(reach_m(fan, 0.375), 2.0, 0.01) << "the box";
  EXPECT_NEAR(reach_m(fan, -0.375), kWall_m, 0.01);
}

TEST(FreeFan, EndsWhereTheOptionSays) {
  FloorPlanOptions options;
  options.max_range_m = 1.5;
  EXPECT_NEAR(reach_m(freeFan(lookAtWall(), camera(), assumed(), options), 0.0), 1.5, 0.01);
}

TEST(FreeFan, PassesUnderWhatIsHighAndOverWhatIsLow) {
  FloorPlanOptions lowRobot;
  lowRobot.min_height_m = 0.5;
  lowRobot.max_height_m = 0.9;
  const auto fan = freeFan(lookAtWall(), camera(), assumed(), lowRobot);
  EXPECT_NEAR(reach_m(fan, 0.375), kWall_m, 0.01) << "over the box";
}

TEST(FreeFan, SaysNothingWhereNothingWasMeasured) {
  cv::Mat depth_m = lookAtWall();
  depth_m.colRange(300, 340) = 0.0;
  const auto fan = freeFan(depth_m, camera(), assumed(), {});
  EXPECT_GT(std::abs(reach_m(fan, 0.0)), 0.0);
  for (const auto& end : fan) EXPECT_GT(std::abs(end.x() / end.z()), 0.02F);
  EXPECT_TRUE(freeFan(cv::Mat::zeros(480, 640, CV_32FC1), camera(), assumed(), {}).empty());
}

/// From 2 m on it rises by 1:12; the wall is 5 m away, where the floor is 0.25 m high.
TEST(FreeFan, GoesUpARamp) {
  const auto ramp = lookAlong([](double x_m) { return std::max(0.0, (x_m - 2.0) / 12.0); }, 5.0);
  FloorPlanOptions far;
  far.max_range_m = 10.0;
  EXPECT_NEAR(reach_m(freeFan(ramp, camera(), seen(), far), 0.0), 5.0, 0.02);
  EXPECT_NEAR(reach_m(freeFan(ramp, camera(), assumed(), far), 0.0), 3.3, 0.15) << "10 cm over a level floor";
}

TEST(FreeFan, GoesDownARamp) {
  const auto ramp = lookAlong([](double x_m) { return -std::max(0.0, (x_m - 2.2) / 10.0); }, 4.5);
  FloorPlanOptions far;
  far.max_range_m = 10.0;
  EXPECT_NEAR(reach_m(freeFan(ramp, camera(), seen(), far), 0.0), 4.5, 0.02);
}

TEST(FreeFan, CrossesAThreshold) {
  const auto sill = lookAlong([](double x_m) { return x_m > 2.5 && x_m < 2.6 ? 0.04 : 0.0; }, 4.0);
  EXPECT_NEAR(reach_m(freeFan(sill, camera(), seen(), {}), 0.0), 4.0, 0.02);
}

TEST(FreeFan, EndsAtStairsThatGoUp) {
  for (const double step_m : {0.12, 0.17}) {
    const auto stairs =
        lookAlong([step_m](double x_m) { return x_m < 2.5 ? 0.0 : step_m * (1 + std::floor((x_m - 2.5) / 0.3)); }, 6.0);
    EXPECT_NEAR(reach_m(freeFan(stairs, camera(), seen(), {}), 0.0), 2.5, 0.1) << step_m;
  }
}

TEST(FreeFan, EndsWhereStairsGoDown) {
  const auto stairs =
      lookAlong([](double x_m) { return x_m < 2.5 ? 0.0 : -0.17 * (1 + std::floor((x_m - 2.5) / 0.3)); }, 6.0);
  const double reached_m = reach_m(freeFan(stairs, camera(), seen(), {}), 0.0);
  EXPECT_LT(reached_m, 2.51);
  EXPECT_GT(reached_m, 2.3);
}

TEST(FreeFan, OfSeenGroundEndsAtAThingAsOfGroundThatIsAssumed) {
  const auto fan = freeFan(lookAtWall(), camera(), seen(), {});
  EXPECT_NEAR(reach_m(fan, 0.0), kWall_m, 0.01);
  EXPECT_NEAR(reach_m(fan, 0.375), 2.0, 0.01) << "the box";
}

TEST(FreeFan, OfDepthThatTellsLittleHasNoNaN) {
  const cv::Mat whole = lookAtWall();
  cv::Mat pixel = cv::Mat::zeros(whole.size(), CV_32FC1);
  pixel.at<float>(400, 320) = whole.at<float>(400, 320);
  cv::Mat odd = whole.clone();
  odd.colRange(0, 200).setTo(std::numeric_limits<float>::quiet_NaN());
  odd.colRange(200, 400).setTo(std::numeric_limits<float>::infinity());
  for (const cv::Mat& depth_m :
       {cv::Mat(), cv::Mat(cv::Mat::zeros(whole.size(), CV_32FC1)), pixel, odd,
        cv::Mat(whole.size(), CV_32FC1, cv::Scalar(1e-30)), cv::Mat(whole.size(), CV_32FC1, cv::Scalar(1e30))}) {
    for (const StandingGround& ground : {assumed(), seen()}) {
      for (const auto& end_m : freeFan(depth_m, camera(), ground, {})) {
        EXPECT_TRUE(end_m.allFinite());
        EXPECT_LE(end_m.norm(), 2 * FloorPlanOptions().max_range_m);
      }
    }
  }
}

}  // namespace
}  // namespace wardslam::mapping
