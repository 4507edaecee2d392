#pragma once

#include <Eigen/Geometry>
#include <deque>
#include <map>

#include "twist.h"
#include "wardslam/core/camera_model.h"
#include "wardslam/odometry/keyframe.h"

namespace wardslam::odometry {

/// When a row is read, as a share of the readout from its middle: -0.5 for the first row, 0.5 for the last.
[[nodiscard]] inline double rowTime(double raw_y_px, const core::CameraModel& camera) {
  return (raw_y_px + 0.5) / camera.height_px - 0.5;
}

/// A map point as an image shows it.
struct SeenPoint {
  Eigen::Vector2d undistorted_px = Eigen::Vector2d::Zero();  ///< As recorded, row by row.
  double depth_m = 0.0;                                      ///< 0: none measured.
  double scale = 1.0;                                        ///< Keypoint::scale.
  double rowTime = 0.0;
};

/// Finds out how long a camera takes to read an image. Two images fit as views of one rigid scene only when what was
/// read later is moved back by as much as the camera moved meanwhile, unless it moved alike in both.
///
/// For each pair of neighbouring images one linear least squares over seven unknowns, how the camera moved (six) and
/// the readout, from the points both show; the pairs' answers are added by how sure they are. That the effect can be
/// seen by so simple means: Ringaby and Forssén, "Scan rectification for structured light range sensors with rolling
/// shutters", ICCV 2011, who measure 30.55 ms for a Kinect.
class ReadoutEstimator {
 public:
  /// `known_s` ± `sigma_s`: what is known beforehand.
  ReadoutEstimator(double known_s, double sigma_s);

  /// The points that a pose rests on. Nothing is learned across a gap.
  void observe(double stamp_s, const Eigen::Isometry3d& T_map_cam, const core::CameraModel& camera,
               std::map<PointId, SeenPoint> points);
  void forgetImages() { images_.clear(); }
  void move(const Eigen::Isometry3d& correction);  ///< Of all poses so far, within the map frame.

  [[nodiscard]] double readout_s() const;
  [[nodiscard]] double sigma_s() const;

 private:
  struct Image {
    double stamp_s = 0.0;
    Eigen::Isometry3d T_map_cam = Eigen::Isometry3d::Identity();
    std::map<PointId, SeenPoint> points;
  };
  [[nodiscard]] Twist twistAt(std::size_t image) const;
  void compare(std::size_t before, std::size_t now, const core::CameraModel& camera);

  std::deque<Image> images_;  ///< The last ones, oldest first.
  double information_per_s2_;
  double weightedSum_per_s_;
};

}  // namespace wardslam::odometry
