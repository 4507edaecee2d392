#include "wardslam/core/mrpt_compat.h"

#include <gtest/gtest.h>
#include <mrpt/system/os.h>

#include <cstdio>

namespace wardslam::core {
namespace {

// As MRPT's header version.h has them; its digits became two a part in 2.10.2.
static_assert(WARDSLAM_MRPT_VERSION(2, 5, 8) == 0x258);
static_assert(WARDSLAM_MRPT_VERSION(2, 5, 11) == 0x25B);
static_assert(WARDSLAM_MRPT_VERSION(2, 10, 1) == 0x2A1);
static_assert(WARDSLAM_MRPT_VERSION(2, 10, 2) == 0x020A02);
static_assert(WARDSLAM_MRPT_VERSION(2, 14, 7) == 0x020E07);
static_assert(WARDSLAM_MRPT_VERSION(2, 15, 14) == 0x020F0E);
static_assert(WARDSLAM_MRPT_VERSION(2, 10, 1) < WARDSLAM_MRPT_VERSION(2, 10, 2), "comparing them needs no more");

TEST(MrptCompat, VersionIsThatOfTheLibrary) {
  int major = 0;
  int minor = 0;
  int patch = 0;
  ASSERT_EQ(std::sscanf(mrpt::system::MRPT_getVersion().c_str(), "MRPT %d.%d.%d", &major, &minor, &patch), 3);
  EXPECT_EQ(WARDSLAM_MRPT_VERSION(major, minor, patch), MRPT_VERSION);
}

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
