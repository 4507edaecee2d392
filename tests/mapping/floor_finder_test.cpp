#include "wardslam/mapping/floor_finder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <vector>

#include "support/textured_room.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::mapping {
namespace {

constexpr double kCameraHeight_m = 1.1;

core::CameraModel camera() { return test::TexturedRoom::camera320x240(); }

/// z up, `height_m` over the floor, looking down by `pitch_rad` and leaning to the right by `roll_rad`.
Eigen::Isometry3d T_floor_cam(double height_m, double pitch_rad, double roll_rad) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation().z() = height_m;
  T.rotate(Eigen::AngleAxisd(pitch_rad, Eigen::Vector3d::UnitY()));
  T.rotate(Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitX()));
  return T * core::T_sensor_cam();
}

/// A level rectangle at a height over the floor.
struct Slab {
  double z_m;
  Eigen::AlignedBox2d area_m;
};

const Slab kFloor{0.0, Eigen::AlignedBox2d(Eigen::Vector2d(-50, -50), Eigen::Vector2d(50, 50))};
const Slab kTable{0.7, Eigen::AlignedBox2d(Eigen::Vector2d(0.5, -1.5), Eigen::Vector2d(1.2, 1.5))};
constexpr double kWallDistance_m = 4.0;

/// The depth image of slabs before a wall across the x axis, as a camera sees them.
cv::Mat look(const std::vector<Slab>& slabs, const Eigen::Isometry3d& T, double noise_m = 0.0, int seed = 7) {
  cv::Mat depth_m(camera().height_px, camera().width_px, CV_32FC1, cv::Scalar(0));
  cv::RNG random(static_cast<std::uint64_t>(seed));
  depth_m.forEach<float>([&](float& value, const int* at) {
    const Eigen::Vector3d ray = T.linear() * camera().unproject({at[1], at[0]}, 1.0);
    const Eigen::Vector3d eye = T.translation();
    double nearest_m = ray.x() > 0 ? (kWallDistance_m - eye.x()) / ray.x() : 0.0;
    for (const Slab& slab : slabs) {
      const double depth = (slab.z_m - eye.z()) / ray.z();
      const Eigen::Vector3d p = eye + depth * ray;
      if (depth > 0 && depth < nearest_m && slab.area_m.contains(p.head<2>())) nearest_m = depth;
    }
    value = static_cast<float>(nearest_m);
  });
  cv::Mat noise(depth_m.size(), CV_32FC1);
  random.fill(noise, cv::RNG::NORMAL, 0.0, noise_m);
  return depth_m + noise;
}

double angle_deg(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle() * 180.0 / M_PI;
}

TEST(FloorFinder, FindsHeightAndTiltOfACameraThatWasThoughtLevel) {
  const auto truth = T_floor_cam(kCameraHeight_m, 0.35, 0.0);
  const auto found = levelWithFloor(look({kFloor}, truth, 0.005), camera(), core::T_sensor_cam());
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->translation().z(), kCameraHeight_m, 0.01);
  EXPECT_LT(angle_deg(*found, truth), 0.5);
}

TEST(FloorFinder, KeepsPlaceAndHeadingOfTheGuess) {
  const auto truth = T_floor_cam(kCameraHeight_m, 0.4, 0.1);
  Eigen::Isometry3d guess(Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitZ()));
  guess.translation() = Eigen::Vector3d(3, 2, 0.3);
  guess = guess * T_floor_cam(0.0, 0.3, 0.0);
  const auto found = levelWithFloor(look({kFloor}, truth), camera(), guess);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->translation().isApprox(Eigen::Vector3d(3, 2, kCameraHeight_m), 1e-3));
  const Eigen::Vector3d ahead = found->linear().col(2);
  EXPECT_NEAR(std::atan2(ahead.y(), ahead.x()), 1.0, 0.06) << "the turn about z";
}

TEST(FloorFinder, TakesTheFloorBeneathALargeTable) {
  const auto truth = T_floor_cam(1.4, 0.5, 0.0);
  const auto found = levelWithFloor(look({kFloor, kTable}, truth), camera(), core::T_sensor_cam());
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->translation().z(), 1.4, 0.01);
}

TEST(FloorFinder, AWallAloneIsNoFloor) {
  EXPECT_FALSE(levelWithFloor(look({}, T_floor_cam(kCameraHeight_m, 0.0, 0.0)), camera(), core::T_sensor_cam()));
}

TEST(FloorFinder, ACeilingIsNoFloor) {
  const Slab ceiling{2.4, kFloor.area_m};
  EXPECT_FALSE(levelWithFloor(look({ceiling}, T_floor_cam(1.1, -0.5, 0.0)), camera(), core::T_sensor_cam()));
}

/// Where up truly is, as the camera sees it.
Eigen::Vector3d upOf(const Eigen::Isometry3d& T) { return T.linear().transpose() * Eigen::Vector3d::UnitZ(); }

double tilt_deg(const core::GroundPlane& plane, const Eigen::Isometry3d& truth) {
  return std::acos(std::min(1.0, plane.normal_cam.dot(upOf(truth)))) * 180.0 / M_PI;
}

/// But for the foot of the wall, which is within the plane's tolerance.
TEST(FindGround, IsExactWithoutNoise) {
  const auto truth = T_floor_cam(kCameraHeight_m, 0.2, 0.05);
  const auto ground = findGround(look({kFloor}, truth), camera(), {});
  ASSERT_TRUE(ground);
  EXPECT_NEAR(ground->height_m, kCameraHeight_m, 2e-3);
  EXPECT_LT(tilt_deg(*ground, truth), 0.05);
}

/// A camera on its side, when somebody says where up is: the floor is at the left of the image.
TEST(FindGround, OfACameraOnItsSideNeedsToKnowUp) {
  const auto truth = T_floor_cam(kCameraHeight_m, 0.2, M_PI / 2);
  GroundExpectation expected;
  expected.up_cam = upOf(T_floor_cam(0.0, 0.0, M_PI / 2));
  const auto ground = findGround(look({kFloor}, truth), camera(), expected);
  ASSERT_TRUE(ground);
  EXPECT_NEAR(ground->height_m, kCameraHeight_m, 2e-3);
  EXPECT_LT(tilt_deg(*ground, truth), 0.05);
}

/// Errors over many noises, in the standard deviations that the covariance tells: their mean square is 3 where it tells
/// all, less where it also tells of what is not in this noise.
TEST(FindGround, TellsHowSureItIs) {
  const auto truth = T_floor_cam(kCameraHeight_m, 0.15, 0.0);
  double sum = 0.0;
  constexpr int kRuns = 20;
  for (int run = 0; run < kRuns; ++run) {
    const auto ground = findGround(look({kFloor}, truth, 0.01, 100 + run), camera(), {});
    ASSERT_TRUE(ground);
    Eigen::Vector3d error;
    error << ground->tangents().transpose() * upOf(truth), kCameraHeight_m - ground->height_m;
    sum += error.dot(ground->covariance.ldlt().solve(error));
    EXPECT_LT(ground->sigmaOf_m({0, kCameraHeight_m, 3.0}), 0.02);
  }
  EXPECT_LT(sum / kRuns, 3.0);
  EXPECT_GT(sum / kRuns, 0.03) << "far too modest";
}

/// Four steps up, 17 cm high and 28 cm deep, 2 m ahead.
std::vector<Slab> stairs(double stepHeight_m) {
  std::vector<Slab> slabs{kFloor};
  for (int i = 0; i < 4; ++i) {
    const double begin_m = 2.0 + 0.28 * i;
    slabs.push_back({stepHeight_m * (i + 1),
                     Eigen::AlignedBox2d(Eigen::Vector2d(begin_m, -2), Eigen::Vector2d(begin_m + 0.28, 2))});
  }
  return slabs;
}

TEST(FindGround, IsTheFloorBeforeStairs) {
  const auto truth = T_floor_cam(kCameraHeight_m, 0.35, 0.0);
  const auto ground = findGround(look(stairs(0.17), truth, 0.003), camera(), {});
  ASSERT_TRUE(ground);
  EXPECT_NEAR(ground->height_m, kCameraHeight_m, 0.01);
  EXPECT_LT(tilt_deg(*ground, truth), 0.5);
}

/// On a landing, with a floor 1.5 m deeper in sight: that is the ground only for who does not know how high it stands.
TEST(FindGround, IsWhereItIsExpectedAboveADrop) {
  const Slab landing{0.0, Eigen::AlignedBox2d(Eigen::Vector2d(-5, -5), Eigen::Vector2d(1.8, 5))};
  const Slab below{-1.5, kFloor.area_m};
  const auto truth = T_floor_cam(kCameraHeight_m, 0.45, 0.0);
  const cv::Mat depth_m = look({landing, below}, truth, 0.003);
  GroundExpectation expected;
  expected.height_m = kCameraHeight_m + 0.05;
  expected.heightTolerance_m = 0.2;
  const auto ground = findGround(depth_m, camera(), expected);
  ASSERT_TRUE(ground);
  EXPECT_NEAR(ground->height_m, kCameraHeight_m, 0.01);
  expected.height_m = 0.5;
  EXPECT_FALSE(findGround(depth_m, camera(), expected)) << "there is none";
}

TEST(FindGround, OnARampIsTheRamp) {
  // The camera stands on it and looks up along it: level with respect to the ramp.
  const auto truth = T_floor_cam(kCameraHeight_m, 0.25, 0.0);
  GroundExpectation expected;
  expected.up_cam = upOf(T_floor_cam(0.0, 0.25 - 5.0 * M_PI / 180.0, 0.0));  // gravity
  expected.maxTilt_rad = 15.0 * M_PI / 180.0;
  const auto ground = findGround(look({kFloor}, truth, 0.003), camera(), expected);
  ASSERT_TRUE(ground);
  EXPECT_LT(tilt_deg(*ground, truth), 0.3);
  expected.maxTilt_rad = 3.0 * M_PI / 180.0;
  EXPECT_FALSE(findGround(look({kFloor}, truth, 0.003), camera(), expected)) << "too steep for who expects it flat";
}

TEST(FindGround, IsNoneWhereNoFloorIsInSight) {
  EXPECT_FALSE(findGround(look({}, T_floor_cam(kCameraHeight_m, 0.0, 0.0)), camera(), {}));
  EXPECT_FALSE(findGround(cv::Mat::zeros(240, 320, CV_32FC1), camera(), {}));
}

TEST(FloorFinder, WithoutDepthThereIsNoFloor) {
  EXPECT_FALSE(levelWithFloor(cv::Mat::zeros(240, 320, CV_32FC1), camera(), core::T_sensor_cam()));
}

TEST(FindGround, DepthThatTellsLittleIsNoGround) {
  const cv::Mat whole = look({kFloor}, T_floor_cam(kCameraHeight_m, 0.4, 0.0));
  ASSERT_TRUE(findGround(whole, camera(), {}));
  const auto part = [&](const cv::Rect& seen) {
    cv::Mat depth_m = cv::Mat::zeros(whole.size(), CV_32FC1);
    whole(seen).copyTo(depth_m(seen));
    return depth_m;
  };
  EXPECT_FALSE(findGround({}, camera(), {}));
  EXPECT_FALSE(findGround(part({160, 200, 1, 1}), camera(), {})) << "one pixel";
  EXPECT_FALSE(findGround(part({0, 200, 320, 1}), camera(), {})) << "a line";
  EXPECT_FALSE(findGround(part({160, 120, 1, 120}), camera(), {})) << "a column";
  for (const float nothing : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    cv::Mat odd(whole.size(), CV_32FC1, cv::Scalar(nothing));
    EXPECT_FALSE(findGround(odd, camera(), {})) << nothing;
    whole.rowRange(120, 240).copyTo(odd.rowRange(120, 240));
    const auto ground = findGround(odd, camera(), {});
    ASSERT_TRUE(ground) << nothing;
    EXPECT_NEAR(ground->height_m, kCameraHeight_m, 0.01);
    EXPECT_TRUE(ground->covariance.allFinite());
  }
}

}  // namespace
}  // namespace wardslam::mapping
