#pragma once

#include <mrpt/core/Clock.h>
#include <mrpt/poses/CPose3D.h>

#include <Eigen/Geometry>

/// Everything that depends on MRPT's conventions or version, in one place.
namespace wardslam::core {

/// UNIX seconds to and from MRPT's clock (100 ns ticks since 1601).
[[nodiscard]] mrpt::Clock::time_point toMrptTime(double stamp_s);
[[nodiscard]] double fromMrptTime(const mrpt::Clock::time_point& stamp);

[[nodiscard]] mrpt::poses::CPose3D toMrpt(const Eigen::Isometry3d& T);
[[nodiscard]] Eigen::Isometry3d fromMrpt(const mrpt::poses::CPose3D& pose);

/// MRPT's sensor frame (x forward, y left, z up) seen from it: the optical frame (x right, y down, z forward).
/// p_sensor = T_sensor_cam() * p_cam.
[[nodiscard]] Eigen::Isometry3d T_sensor_cam();

}  // namespace wardslam::core
