#include "wardslam/core/mrpt_compat.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace wardslam::core {
namespace {

TEST(MrptCompat, UnixEpochIsMrptsTick116444736e9) {
  EXPECT_EQ(toMrptTime(0.0).time_since_epoch().count(), 116444736000000000LL);
  EXPECT_EQ(toMrptTime(1.5).time_since_epoch().count(), 116444736015000000LL);
}

TEST(MrptCompat, StampsKeepTheirMicroseconds) {
  for (int i = 0; i < 1000; ++i) {
    const double stamp_s = 1305031102.0 + i * 0.033357 + i * 1e-6;
    char before[32];
    char after[32];
    std::snprintf(before, sizeof before, "%.6f", stamp_s);
    std::snprintf(after, sizeof after, "%.6f", fromMrptTime(toMrptTime(stamp_s)));
    EXPECT_STREQ(before, after);
  }
}

TEST(MrptCompat, PosesGoThereAndBack) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = (Eigen::AngleAxisd(2.9, Eigen::Vector3d(1, -2, 0.5).normalized())).toRotationMatrix();
  T.translation() = Eigen::Vector3d(1, -20, 300);
  EXPECT_TRUE(fromMrpt(toMrpt(T)).isApprox(T, 1e-12));
}

TEST(MrptCompat, MrptAnglesTurnAsTheMatrixDoes) {
  const mrpt::poses::CPose3D quarterTurnLeft(1, 2, 3, M_PI / 2, 0, 0);
  const Eigen::Vector3d p = fromMrpt(quarterTurnLeft) * Eigen::Vector3d(1, 0, 0);
  EXPECT_TRUE(p.isApprox(Eigen::Vector3d(1, 3, 3), 1e-12)) << p.transpose();
}

TEST(MrptCompat, OpticalAxesInTheSensorFrame) {
  EXPECT_TRUE((T_sensor_cam() * Eigen::Vector3d::UnitZ()).isApprox(Eigen::Vector3d::UnitX())) << "forward";
  EXPECT_TRUE((T_sensor_cam() * Eigen::Vector3d::UnitX()).isApprox(-Eigen::Vector3d::UnitY())) << "right";
  EXPECT_TRUE((T_sensor_cam() * Eigen::Vector3d::UnitY()).isApprox(-Eigen::Vector3d::UnitZ())) << "down";
  EXPECT_NEAR(T_sensor_cam().linear().determinant(), 1.0, 1e-12);
}

}  // namespace
}  // namespace wardslam::core
