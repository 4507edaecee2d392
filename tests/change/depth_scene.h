#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "wardslam/core/frame.h"

/// A room for tests as a depth camera sees it: a wall 3 m away and flat things in front of it, all facing the camera,
/// which looks along z and moves without turning.
namespace wardslam::change::test {

/// Its middle and size in metres, in the map frame.
struct Thing {
  std::uint16_t id;
  core::ClassId classId;
  Eigen::Vector3d p_map_m;
  double width_m;
  double height_m;
};

class DepthScene {
 public:
  static core::CameraModel camera() {
    core::CameraModel camera;
    camera.width_px = 320;
    camera.height_px = 240;
    camera.fx_px = camera.fy_px = 260.0;
    camera.cx_px = 160.0;
    camera.cy_px = 120.0;
    return camera;
  }

  Thing& add(const Thing& thing) { return things_.emplace_back(thing); }
  [[nodiscard]] Thing& thing(std::size_t i) { return things_[i]; }

  /// Seen from `c`: depth and masks; later things hide earlier ones.
  [[nodiscard]] core::Frame frame(double stamp_s, const Eigen::Vector3d& c = Eigen::Vector3d::Zero()) const {
    constexpr double kWall_m = 3.0;
    core::Frame frame;
    frame.stamp_s = stamp_s;
    frame.camera = camera();
    const cv::Size size(frame.camera.width_px, frame.camera.height_px);
    frame.gray = cv::Mat(size, CV_8UC1, cv::Scalar(0));
    frame.depth_m = cv::Mat(size, CV_32FC1, cv::Scalar(kWall_m - c.z()));
    frame.segmentation.classIds = cv::Mat(size, CV_8UC1, cv::Scalar(0));
    frame.segmentation.instanceIds = cv::Mat(size, CV_16UC1, cv::Scalar(0));
    for (const Thing& thing : things_) draw(thing, thing.p_map_m - c, frame);
    return frame;
  }

 private:
  static void draw(const Thing& thing, const Eigen::Vector3d& p_m, core::Frame& frame) {
    const double scale = frame.camera.fx_px / p_m.z();
    const auto corner = [&](double side) {
      return cv::Point(cvRound(frame.camera.cx_px + (p_m.x() + side * thing.width_m / 2) * scale),
                       cvRound(frame.camera.cy_px + (p_m.y() + side * thing.height_m / 2) * scale));
    };
    const cv::Rect box = cv::Rect(corner(-1), corner(1)) & cv::Rect({}, frame.depth_m.size());
    if (box.empty()) return;
    frame.depth_m(box).setTo(p_m.z());
    frame.segmentation.classIds(box).setTo(thing.classId);
    frame.segmentation.instanceIds(box).setTo(thing.id);
    frame.segmentation.instances.push_back({thing.id, thing.classId, 0.9F, box});
  }

  std::vector<Thing> things_;
};

inline constexpr double kFrameTime_s = 1.0 / 30;

inline Eigen::Isometry3d poseAt(const Eigen::Vector3d& p_map_m) {
  Eigen::Isometry3d T_map_cam = Eigen::Isometry3d::Identity();
  T_map_cam.translation() = p_map_m;
  return T_map_cam;
}

}  // namespace wardslam::change::test
