#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <map>
#include <vector>

#include "wardslam/mapping/view.h"

/// Small hand-made scenes: boxes in an empty space, rendered without noise. The map frame has z up.
namespace wardslam::mapping::scene {

inline constexpr core::ClassId kPerson = 1;
inline constexpr core::ClassId kChair = 57;
inline constexpr core::ClassId kCouch = 58;
inline constexpr core::ClassId kBed = 60;

struct Thing {
  Eigen::AlignedBox3d box_m;
  core::ClassId classId = 0;
  std::uint16_t instance = 0;  ///< 0 = not segmented.
  cv::Vec3b bgr{120, 120, 120};
};

inline Eigen::AlignedBox3d box(const Eigen::Vector3d& center_m, const Eigen::Vector3d& size_m) {
  return {center_m - size_m / 2, center_m + size_m / 2};
}

/// A wall 3 m ahead (x = 3) of a camera in the origin that looks along x.
inline Thing wall() { return {box({3.05, 0, 1}, {0.1, 6, 4}), 0, 0, {200, 190, 180}}; }

/// A chair-sized block.
inline Thing chair(double x_m, double y_m, std::uint16_t instance, core::ClassId classId = kChair) {
  return {box({x_m, y_m, 0.5}, {0.5, 0.5, 1.0}), classId, instance, {40, 80, 160}};
}

inline core::CameraModel camera() {
  core::CameraModel camera;
  camera.width_px = 200;
  camera.height_px = 150;
  camera.fx_px = camera.fy_px = 150.0;
  camera.cx_px = 99.5;
  camera.cy_px = 74.5;
  return camera;
}

/// From there, turned about the vertical; yaw 0 looks along x.
inline Eigen::Isometry3d cameraAt(const Eigen::Vector3d& p_map_m, double yaw_rad = 0.0) {
  Eigen::Isometry3d T_map_cam = Eigen::Isometry3d::Identity();
  Eigen::Matrix3d R_level_cam;  // optical axes: x right, y down, z ahead
  R_level_cam << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  T_map_cam.linear() = Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix() * R_level_cam;
  T_map_cam.translation() = p_map_m;
  return T_map_cam;
}

/// Range along the ray at which it enters the box; infinite where it does not.
inline double entry(const Eigen::AlignedBox3d& box_m, const Eigen::Vector3d& origin_m, const Eigen::Vector3d& ray) {
  double enter = 0.0;
  double leave = std::numeric_limits<double>::infinity();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double a = (box_m.min()[axis] - origin_m[axis]) / ray[axis];
    const double b = (box_m.max()[axis] - origin_m[axis]) / ray[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter < leave && enter > 0 ? enter : std::numeric_limits<double>::infinity();
}

/// What the camera sees at `T_map_cam`, as a view that hangs on the keyframe with the pose `T_map_keyframe`.
inline View render(const std::vector<Thing>& things, const Eigen::Isometry3d& T_map_cam, double stamp_s,
                   odometry::KeyframeId keyframe = 1, const Eigen::Isometry3d& T_map_keyframe = cameraAt({0, 0, 1}),
                   const core::CameraModel& camera = scene::camera()) {
  View view;
  view.keyframe = keyframe;
  view.T_keyframe_cam = T_map_keyframe.inverse() * T_map_cam;
  view.stamp_s = stamp_s;
  view.camera = camera;
  const cv::Size size(view.camera.width_px, view.camera.height_px);
  view.color_bgr = cv::Mat(size, CV_8UC3, cv::Scalar::all(0));
  view.depth_m = cv::Mat(size, CV_32FC1, cv::Scalar(0));
  view.segmentation.classIds = cv::Mat(size, CV_8UC1, cv::Scalar(0));
  view.segmentation.instanceIds = cv::Mat(size, CV_16UC1, cv::Scalar(0));
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      const Eigen::Vector3d ray = T_map_cam.linear() * view.camera.unproject({u, v}, 1.0);
      double nearest_m = std::numeric_limits<double>::infinity();
      for (const Thing& thing : things) {
        const double range_m = entry(thing.box_m, T_map_cam.translation(), ray);
        if (range_m >= nearest_m) continue;
        nearest_m = range_m;
        view.color_bgr.at<cv::Vec3b>(v, u) = thing.bgr;
        view.depth_m.at<float>(v, u) = static_cast<float>(range_m);
        view.segmentation.classIds.at<std::uint8_t>(v, u) = thing.instance == 0 ? core::ClassId{0} : thing.classId;
        view.segmentation.instanceIds.at<std::uint16_t>(v, u) = thing.instance;
      }
    }
  }
  std::map<std::uint16_t, core::ClassId> instances;
  for (const Thing& thing : things) {
    if (thing.instance != 0) instances[thing.instance] = thing.classId;
  }
  for (const auto& [id, classId] : instances) {
    view.segmentation.instances.push_back({id, classId, 1.0F, cv::Rect({}, size)});
  }
  return view;
}

}  // namespace wardslam::mapping::scene
