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

  /// Where a camera stands that tracking begins anew with: where it is believed to, but upright over the ground in its
  /// image, which lies in the map frame as the ground did that was seen before. Where it is believed to when either was
  /// not in sight.
  [[nodiscard]] Eigen::Isometry3d placeAnew(const Eigen::Isometry3d& T_map_cam, const core::CameraModel& camera,
                                            const cv::Mat& depth_m) const;

  /// All there is moves within the map frame.
  void follow(const Eigen::Isometry3d& correction);

 private:
  void carryTo(const odometry::Keyframe& keyframe);

  std::optional<core::GroundPlane> last_;  ///< Seen from the newest keyframe.
  double way_m_ = 0.0;                     ///< Since it was in sight.
  std::uint32_t submap_ = 0;
  Eigen::Vector3d up_map_ = Eigen::Vector3d::Zero();        ///< Of all that was seen of it, added up.
  Eigen::Vector3d ground_map_m_ = Eigen::Vector3d::Zero();  ///< Under the newest keyframe that saw it.
};

}  // namespace wardslam::mapping
