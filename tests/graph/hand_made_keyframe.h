#pragma once

#include <memory>
#include <vector>

#include "wardslam/odometry/keyframe.h"

namespace wardslam::test {

/// A keyframe that sees these points two metres away: point i in key point i, 30 px apart.
[[nodiscard]] inline std::shared_ptr<odometry::Keyframe> handMadeKeyframe(odometry::KeyframeId id,
                                                                          const std::vector<odometry::PointId>& points,
                                                                          std::uint32_t submap = 1) {
  auto keyframe = std::make_shared<odometry::Keyframe>();
  keyframe->id = id;
  keyframe->submap = submap;
  for (std::size_t i = 0; i < points.size(); ++i) {
    core::Keypoint keypoint;
    keypoint.raw_px = keypoint.undistorted_px = {20.0F + 30.0F * static_cast<float>(i), 100.0F};
    keypoint.depth_m = 2.0F;
    keyframe->features.keypoints.push_back(keypoint);
    keyframe->sightings.push_back({points[i], i});
  }
  keyframe->features.descriptors = cv::Mat(static_cast<int>(points.size()), 32, CV_8UC1, cv::Scalar(0));
  return keyframe;
}

}  // namespace wardslam::test
