#pragma once

#include <mrpt/core/Clock.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/rtti/CObject.h>
#include <mrpt/version.h>

#include <Eigen/Geometry>

/// Everything that depends on MRPT's conventions or version, in one place; what concerns one of MRPT's libraries only,
/// in mrpt_<library>_compat.h beside it. docs/architecture.md says what else changed in MRPT 3.
#if __has_include(<mrpt/viz/Scene.h>)
#error "This is written for MRPT 2.5 to 2.15, and what was found is MRPT 3"
#endif

/// What MRPT_VERSION is in this version of MRPT: one hexadecimal digit a part before 2.10.2, two from there on. The
/// numbers grow with the version all the same, so that they can be compared.
#define WARDSLAM_MRPT_VERSION(major, minor, patch)                                                \
  (10000 * (major) + 100 * (minor) + (patch) < 21002 ? 0x100 * (major) + 0x10 * (minor) + (patch) \
                                                     : 0x10000 * (major) + 0x100 * (minor) + (patch))
static_assert(MRPT_VERSION >= WARDSLAM_MRPT_VERSION(2, 5, 0), "This is written for MRPT 2.5 to 2.15");

/// Within an abstract class that MRPT can name: from 2.14.0 on the macro takes the namespace too.
#if MRPT_VERSION >= WARDSLAM_MRPT_VERSION(2, 14, 0)
#define WARDSLAM_DEFINE_VIRTUAL_MRPT_OBJECT(class_name, class_namespace) \
  DEFINE_VIRTUAL_MRPT_OBJECT(class_name, class_namespace)
#else
#define WARDSLAM_DEFINE_VIRTUAL_MRPT_OBJECT(class_name, class_namespace) DEFINE_VIRTUAL_MRPT_OBJECT(class_name)
#endif

/// MRPT's scene by name only, for headers: COpenGLScene is another name of Scene from 2.7.0 on.
namespace mrpt::opengl {
#if MRPT_VERSION >= WARDSLAM_MRPT_VERSION(2, 7, 0)
class Scene;
using COpenGLScene = Scene;
#else
class COpenGLScene;
#endif
}  // namespace mrpt::opengl

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
