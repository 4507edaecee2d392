#pragma once

#include <mrpt/obs/CSensoryFrame.h>

#include <cstddef>
#include <map>

#include "wardslam/mrpt_slam/map_builder_options.h"
#include "wardslam/pipeline/frame_observer.h"

namespace wardslam::mrpt_slam {

/// What was observed where keyframes were taken, small enough to be kept for all of them: of the RGB-D scan the points
/// that do not move, in its sensor's frame, and outside, if at all, its colour image with the depth of what does not
/// move, as a sensor has them whose cameras coincide; what else the robot observed as it
/// came.
class KeyframeScans : public pipeline::FrameObserver {
 public:
  /// Throws core::InputError when the folder for images cannot be made.
  explicit KeyframeScans(const MapBuilderOptions& options);

  /// Before each frame: all that was observed with it.
  void setObserved(const mrpt::obs::CSensoryFrame& observed) { observed_ = observed; }

  void onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) override;
  void onUpdate(const odometry::MapUpdate& update) override;  ///< Keyframes that are given up take their scans along.

  struct Scan {
    Eigen::Isometry3d T_base_cam = Eigen::Isometry3d::Identity();
    mrpt::obs::CSensoryFrame::Ptr observed;
  };
  [[nodiscard]] const std::map<odometry::KeyframeId, Scan>& all() const { return scans_; }

 private:
  void storeImages(const core::Frame& frame, odometry::KeyframeId keyframe, mrpt::obs::CObservation3DRangeScan& scan);

  MapBuilderOptions options_;
  mrpt::obs::CSensoryFrame observed_;
  std::map<odometry::KeyframeId, Scan> scans_;
};

}  // namespace wardslam::mrpt_slam
