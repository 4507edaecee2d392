#include "rolling_shutter.h"

#include <utility>

namespace wardslam::odometry {
namespace {

constexpr double kNearest_m = 0.05;
constexpr double kCalibrated_s = 1e-4;  // how sure a calibration is

}  // namespace

core::Features rectified(const core::Features& features, const core::CameraModel& camera, const Twist& twist,
                         double readout_s) {
  core::Features atOnce = features;
  for (core::Keypoint& keypoint : atOnce.keypoints) {
    const double late_s = readout_s * rowTime(static_cast<double>(keypoint.raw_px.y), camera);
    const Eigen::Isometry3d T_middle_late = after(twist, late_s);
    const Eigen::Vector2d seen_px(keypoint.undistorted_px.x, keypoint.undistorted_px.y);
    // Of what has no depth the direction alone is known.
    const Eigen::Vector3d p_m = keypoint.hasDepth()
                                    ? T_middle_late * camera.unproject(seen_px, static_cast<double>(keypoint.depth_m))
                                    : T_middle_late.linear() * camera.unproject(seen_px, 1.0);
    if (p_m.z() < kNearest_m) continue;
    const Eigen::Vector2d px = camera.project(p_m);
    keypoint.undistorted_px = {static_cast<float>(px.x()), static_cast<float>(px.y())};
    if (keypoint.hasDepth()) keypoint.depth_m = static_cast<float>(p_m.z());
  }
  return atOnce;
}

RollingShutter::RollingShutter(const RollingShutterOptions& options)
    : isSettled_(options.readout_s != 0.0),
      learns_(options.learn),
      estimator_(options.readout_s, options.readout_sigma_s) {}

void RollingShutter::begin(const core::CameraModel& camera) {
  if (std::exchange(isSettled_, true) || camera.readout_s == 0.0) return;
  estimator_ = ReadoutEstimator(camera.readout_s, kCalibrated_s);
  learns_ = false;
}

core::Features RollingShutter::rectified(const core::Features& features, const core::CameraModel& camera) const {
  return twist_ && readout_s() != 0.0 ? odometry::rectified(features, camera, *twist_, readout_s()) : features;
}

void RollingShutter::moved(const Eigen::Isometry3d& T_before_now, double since_s) {
  const bool isTelling = since_s > 0.0 && since_s < kLongestStep_s;
  twist_ = isTelling ? std::optional(twistOf(T_before_now, since_s)) : std::nullopt;
}

void RollingShutter::learn(double stamp_s, const Eigen::Isometry3d& T_map_cam, const core::CameraModel& camera,
                           std::map<PointId, SeenPoint> points) {
  if (learns_) estimator_.observe(stamp_s, T_map_cam, camera, std::move(points));
}

void RollingShutter::forgetMotion() {
  twist_.reset();
  estimator_.forgetImages();
}

}  // namespace wardslam::odometry
