#include "wardslam/core/mrpt_compat.h"

#include <mrpt/math/CMatrixFixed.h>

namespace wardslam::core {

mrpt::Clock::time_point toMrptTime(double stamp_s) { return mrpt::Clock::fromDouble(stamp_s); }

double fromMrptTime(const mrpt::Clock::time_point& stamp) { return mrpt::Clock::toDouble(stamp); }

mrpt::poses::CPose3D toMrpt(const Eigen::Isometry3d& T) {
  return mrpt::poses::CPose3D(mrpt::math::CMatrixDouble44(T.matrix()));
}

Eigen::Isometry3d fromMrpt(const mrpt::poses::CPose3D& pose) {
  Eigen::Isometry3d T;
  T.matrix() = pose.getHomogeneousMatrixVal<mrpt::math::CMatrixDouble44>().asEigen();
  return T;
}

Eigen::Isometry3d T_sensor_cam() {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  // clang-format off
  T.linear() << 0,  0, 1,
               -1,  0, 0,
                0, -1, 0;
  // clang-format on
  return T;
}

}  // namespace wardslam::core
