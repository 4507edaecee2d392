#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "wardslam/core/frame.h"
#include "wardslam/knowledge/motion_rules.h"

namespace wardslam::change {

template <class Moment>
class MomentWindow;

/// Motion of single movable things against the map, whose poses come from elsewhere: the surface of each is compared
/// with what the last second of depth images saw at its place, and what it was made of then with what is there now. A
/// thing that came or went was seen through
/// there; one that rests was met at the same depth. The rest of the scene, compared in the same way, tells how much of
/// that is noise and error of the poses.
class InstanceMotion {
 public:
  /// `rules` must outlive this object.
  explicit InstanceMotion(const knowledge::MotionRules& rules);
  ~InstanceMotion();
  InstanceMotion(InstanceMotion&&) noexcept;
  InstanceMotion& operator=(InstanceMotion&&) = delete;
  InstanceMotion(const InstanceMotion&) = delete;
  InstanceMotion& operator=(const InstanceMotion&) = delete;

  /// The next image, in order of time, with its segmentation and p_map = T_map_cam * p_cam.
  void update(const core::Frame& frame, const Eigen::Isometry3d& T_map_cam);

  /// Where the camera is got lost, or the map another one: earlier images cannot be compared any more. What was found
  /// out stays.
  void forgetImages();

  /// Log-odds that the thing with this id moves, by observation alone; 0 = nothing is known.
  [[nodiscard]] double evidence(std::uint16_t instanceId) const;

 private:
  struct Moment;

  [[nodiscard]] Moment momentOf(const core::Frame& frame, const Eigen::Isometry3d& T_map_cam) const;
  [[nodiscard]] std::map<std::uint16_t, double> newsOf(const Moment& now) const;

  const knowledge::MotionRules& rules_;
  cv::Mat isMover_;  ///< Table over the class ids.
  std::unique_ptr<MomentWindow<Moment>> past_;
  std::map<std::uint16_t, double> logOdds_;
};

}  // namespace wardslam::change
