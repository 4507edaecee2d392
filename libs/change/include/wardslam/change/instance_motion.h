#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <deque>
#include <map>
#include <vector>

#include "wardslam/core/frame.h"
#include "wardslam/knowledge/motion_rules.h"

namespace wardslam::change {

/// Whether movable things are seen to move: the surface of each is compared with what the last second of depth images
/// saw at its place, and what it was made of then with what is there now. A thing that came or went was seen through
/// there; one that rests was met at the same depth. The rest of the scene, compared in the same way, tells how much of
/// that is noise and error of the poses.
class InstanceMotion {
 public:
  /// `rules` must outlive this object.
  explicit InstanceMotion(const knowledge::MotionRules& rules);

  /// The next image, in order of time, with its segmentation and p_map = T_map_cam * p_cam.
  void update(const core::Frame& frame, const Eigen::Isometry3d& T_map_cam);

  /// Where the camera is got lost, or the map another one: earlier images cannot be compared any more. What was found
  /// out stays.
  void forgetImages() { past_.clear(); }

  /// Log-odds that the thing with this id moves, by observation alone; 0 = nothing is known.
  [[nodiscard]] double evidence(std::uint16_t instanceId) const;

 private:
  using Points = std::vector<Eigen::Vector3d>;

  /// An image of the last second.
  struct Moment {
    double stamp_s = 0.0;
    Eigen::Isometry3d T_cam_map = Eigen::Isometry3d::Identity();
    core::CameraModel camera;
    cv::Mat depth_m;
    cv::Mat movers;                          ///< CV_8UC1, not 0 on what moves by itself.
    std::map<std::uint16_t, Points> things;  ///< Points on each movable instance, in the map frame.
    Points scene;                            ///< Points on none, nor on what moves by itself.
  };

  [[nodiscard]] Moment momentOf(const core::Frame& frame, const Eigen::Isometry3d& T_map_cam) const;
  [[nodiscard]] std::vector<const Moment*> references(double stamp_s) const;
  static void compare(const Moment& past, const Moment& now, std::map<std::uint16_t, double>& evidence);

  const knowledge::MotionRules& rules_;
  cv::Mat isMover_;          ///< Table over the class ids.
  std::deque<Moment> past_;  ///< In order of time.
  std::map<std::uint16_t, double> logOdds_;
};

}  // namespace wardslam::change
