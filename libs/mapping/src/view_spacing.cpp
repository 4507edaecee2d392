#include "wardslam/mapping/view_spacing.h"

namespace wardslam::mapping {

bool isFarEnough(const ViewOptions& options, const core::StampedPose& last, const core::StampedPose& now) {
  const Eigen::Isometry3d step = last.T_map_cam.inverse() * now.T_map_cam;
  return step.translation().norm() >= options.step_m || Eigen::AngleAxisd(step.linear()).angle() >= options.turn_rad ||
         now.stamp_s - last.stamp_s >= options.gap_s;
}

}  // namespace wardslam::mapping
