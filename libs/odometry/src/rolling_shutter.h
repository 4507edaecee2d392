#pragma once

#include <map>
#include <optional>

#include "readout_estimator.h"
#include "twist.h"
#include "wardslam/core/camera_model.h"
#include "wardslam/core/keypoint.h"
#include "wardslam/odometry/odometry_options.h"

namespace wardslam::odometry {

/// The key points (undistorted pixel, and depth) where a camera moving like this would have seen them had it read all
/// rows at once, in the middle of the readout.
[[nodiscard]] core::Features rectified(const core::Features& features, const core::CameraModel& camera,
                                       const Twist& twist, double readout_s);

/// Most colour cameras read an image row by row, and in 30 ms a camera that turns sees what is low in the image some
/// pixels off from what is high. Takes that out, and learns from the images themselves how long the readout takes.
class RollingShutter {
 public:
  explicit RollingShutter(const RollingShutterOptions& options);

  /// What the calibration of the first camera says of the readout is taken, where the options say nothing, and nothing
  /// is learned then.
  void begin(const core::CameraModel& camera);

  /// Key points as if read at once, the camera moving on as it did last.
  [[nodiscard]] core::Features rectified(const core::Features& features, const core::CameraModel& camera) const;

  /// It moved along `T_before_now` since the image before. Images long apart, or a clock that stands, tell nothing.
  void moved(const Eigen::Isometry3d& T_before_now, double since_s);

  /// The points of an image that its pose rests on, as recorded.
  void learn(double stamp_s, const Eigen::Isometry3d& T_map_cam, const core::CameraModel& camera,
             std::map<PointId, SeenPoint> points);

  void forgetMotion();
  void move(const Eigen::Isometry3d& correction) { estimator_.move(correction); }

  /// From the first row to the last, negative where rows are read from below; 0 as long as nobody knows.
  [[nodiscard]] double readout_s() const { return estimator_.readout_s(); }

 private:
  bool isSettled_;  ///< Where learning starts: by the options, or by the first camera.
  bool learns_;
  ReadoutEstimator estimator_;
  std::optional<Twist> twist_;
};

}  // namespace wardslam::odometry
