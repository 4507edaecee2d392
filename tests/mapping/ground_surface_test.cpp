#include "ground_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "wardslam/core/mrpt_compat.h"

namespace wardslam::mapping {
namespace {

constexpr double kEye_m = 1.1;
using Height = std::function<double(double x_m)>;

/// Keyframes every metre along x, over a floor 2 m wide whose cloud has a point every 2.5 cm, and that each saw 3 m
/// far. `T_map_true` leans the whole.
SemanticMap corridor(const Height& floor_m, double length_m, double driven_m,
                     const Eigen::Isometry3d& T_map_true = Eigen::Isometry3d::Identity()) {
  SemanticMap map;
  for (std::uint64_t id = 1; static_cast<double>(id) <= driven_m; ++id) {
    const auto x_m = static_cast<double>(id) - 1.0;
    const double slope = (floor_m(x_m + 0.1) - floor_m(x_m - 0.1)) / 0.2;
    MappedKeyframe& keyframe = map.keyframes[id];
    keyframe.T_map_cam = T_map_true * Eigen::Translation3d(x_m, 0, floor_m(x_m) + kEye_m) *
                         Eigen::AngleAxisd(-std::atan(slope), Eigen::Vector3d::UnitY()) * core::T_sensor_cam();
    keyframe.freeFan_cam_m = {{-0.5F, 0.0F, 3.0F}, {0.0F, 0.0F, 3.0F}, {0.5F, 0.0F, 3.0F}};
    keyframe.ground = core::GroundPlane{};
    keyframe.ground->height_m = kEye_m * std::cos(std::atan(slope));
  }
  const Eigen::Isometry3d T_cam_true = map.keyframes.at(1).T_map_cam.inverse() * T_map_true;
  for (double x_m = -1.0; x_m < length_m; x_m += 0.025) {
    for (double y_m = -1.0; y_m < 1.0; y_m += 0.025) {
      SemanticPoint point;
      point.p_cam_m = (T_cam_true * Eigen::Vector3d(x_m, y_m, floor_m(x_m))).cast<float>();
      map.cloud[1].points.push_back(point);
    }
  }
  return map;
}

double flat(double /*x_m*/) { return 0.0; }

TEST(GroundSurface, IsAtZeroWhereNoKeyframeSawAny) {
  SemanticMap map = corridor(flat, 5.0, 3.0);
  for (auto& [id, keyframe] : map.keyframes) keyframe.ground.reset();
  const GroundSurface ground(map);
  EXPECT_TRUE(ground.carries(1));
  EXPECT_NEAR(ground.heightOver_m({1, 0, 0.7F}), 0.7, 1e-6);
}

/// 1 degree: 35 cm at 20 m.
TEST(GroundSurface, LeansWithTheMap) {
  Eigen::Isometry3d T_map_true(Eigen::AngleAxisd(M_PI / 180.0, Eigen::Vector3d(0.6, 0.8, 0)));
  T_map_true.translation().z() = 0.4;
  const GroundSurface ground(corridor(flat, 20.0, 20.0, T_map_true));
  for (const double x_m : {0.0, 10.0, 19.5}) {
    const Eigen::Vector3f over = (T_map_true * Eigen::Vector3d(x_m, 0.5, 0.3)).cast<float>();
    EXPECT_NEAR(ground.heightOver_m(over), 0.3, 0.012) << x_m;
  }
}

/// Up 1:12 from 3 m to 9 m, level after it; nobody drove on it.
TEST(GroundSurface, GoesUpARamp) {
  const Height ramp = [](double x_m) { return std::clamp((x_m - 3.0) / 12.0, 0.0, 0.5); };
  const GroundSurface ground(corridor(ramp, 11.0, 1.0));
  for (const double x_m : {1.0, 4.0, 6.0, 8.0, 10.5}) {
    EXPECT_NEAR(ground.heightOver_m(Eigen::Vector3d(x_m, 0, ramp(x_m) + 0.2).cast<float>()), 0.2, 0.025) << x_m;
  }
}

TEST(GroundSurface, DoesNotClimbStairsNorWhatSlants) {
  const Height stairs = [](double x_m) { return x_m < 3.0 ? 0.0 : 0.17 * (1 + std::floor((x_m - 3.0) / 0.3)); };
  EXPECT_GT(GroundSurface(corridor(stairs, 6.0, 1.0)).heightOver_m({5.0F, 0, static_cast<float>(stairs(5.0))}), 1.0);
  const Height slanting = [](double x_m) { return x_m < 3.0 ? 0.0 : 0.3 * (x_m - 3.0); };  // 17 degrees
  EXPECT_GT(GroundSurface(corridor(slanting, 6.0, 1.0)).heightOver_m({5.5F, 0, static_cast<float>(slanting(5.5))}),
            0.4);
}

TEST(GroundSurface, WhereNothingIsKnownIsAsNearby) {
  SemanticMap map = corridor(flat, 5.0, 3.0);
  SemanticPoint bed;
  bed.p_cam_m = (map.keyframes.at(1).T_map_cam.inverse() * Eigen::Vector3d(2, 3, 0.6)).cast<float>();
  map.cloud[1].points.insert(map.cloud[1].points.end(), 50, bed);
  EXPECT_NEAR(GroundSurface(map).heightOver_m({2, 3, 0.6F}), 0.6, 0.02);
}

TEST(GroundSurface, OfTwoStoreysIsThatOfMostKeyframes) {
  SemanticMap map = corridor(flat, 6.0, 4.0);
  const SemanticMap above = corridor([](double /*x_m*/) { return 3.2; }, 6.0, 3.0);
  for (const auto& [id, keyframe] : above.keyframes) map.keyframes[id + 100] = keyframe;
  const GroundSurface ground(map);
  EXPECT_TRUE(ground.carries(2));
  EXPECT_FALSE(ground.carries(102));
  EXPECT_NEAR(ground.heightOver_m({1, 0, 0.5F}), 0.5, 0.02);
}

}  // namespace
}  // namespace wardslam::mapping
