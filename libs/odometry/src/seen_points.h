#pragma once

#include <map>
#include <vector>

#include "pose_tracker.h"
#include "rolling_shutter.h"

namespace wardslam::odometry {

/// What the readout is learned from: where points were recorded in this image, and when.
inline std::map<PointId, SeenPoint> seenPoints(const TrackedImage& view, const std::vector<Match>& matches) {
  std::map<PointId, SeenPoint> points;
  for (const Match& match : matches) {
    const core::Keypoint& keypoint = view.recorded.keypoints[match.keypoint];
    points[match.point] = {{keypoint.undistorted_px.x, keypoint.undistorted_px.y},
                           static_cast<double>(keypoint.depth_m),
                           static_cast<double>(keypoint.scale),
                           rowTime(static_cast<double>(keypoint.raw_px.y), view.camera)};
  }
  return points;
}

}  // namespace wardslam::odometry
