#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "wardslam/core/ground_plane.h"
#include "wardslam/odometry/keyframe.h"

namespace wardslam::mapping {

/// Looks for the ground in the images of keyframes as they are made, each where those before it had the ground.
class GroundWatch {
 public:
  /// The same keyframe, with the ground that its image shows (`depth_m` as in core::Frame). Keyframes come in order.
  [[nodiscard]] std::shared_ptr<const odometry::Keyframe> look(
      const std::shared_ptr<const odometry::Keyframe>& keyframe, const cv::Mat& depth_m);

 private:
  void carryTo(const odometry::Keyframe& keyframe);

  std::optional<core::GroundPlane> last_;  ///< Seen from the newest keyframe.
  double way_m_ = 0.0;                     ///< Since it was in sight.
  std::uint32_t submap_ = 0;
};

}  // namespace wardslam::mapping
