#include "wardslam/mapping/floor_finder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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
cv::Mat look(const std::vector<Slab>& slabs, const Eigen::Isometry3d& T, double noise_m = 0.0) {
  cv::Mat depth_m(camera().height_px, camera().width_px, CV_32FC1, cv::Scalar(0));
  cv::RNG random(7);
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

TEST(FloorFinder, WithoutDepthThereIsNoFloor) {
  EXPECT_FALSE(levelWithFloor(cv::Mat::zeros(240, 320, CV_32FC1), camera(), core::T_sensor_cam()));
}

}  // namespace
}  // namespace wardslam::mapping
