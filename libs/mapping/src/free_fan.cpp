#include "free_fan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ground_slope.h"
#include "wardslam/mapping/depth_points.h"

namespace wardslam::mapping {
namespace {

constexpr int kStep_px = 4;
constexpr std::size_t kBlockingPoints = 3;  // fewer in one direction are stray measurements
constexpr double kFollowed_m = 0.5;         // ground may rise or fall unseen for so long

/// What was measured in one direction.
struct Measured {
  double range_m = 0.0;
  double height_m = 0.0;  ///< Over the plane of the ground.
};

/// How the ground goes on in one direction, from its plane outwards.
class GroundProfile {
 public:
  explicit GroundProfile(bool isFollowed) : isFollowed_(isFollowed) {}

  /// The height of a point over the ground, points coming in order of their range.
  double heightOver_m(const Measured& point) {
    const double above_m = point.height_m - height_m_;
    if (!isFollowed_) return above_m;
    const double way_m = std::min(std::max(0.0, point.range_m - last_m_), kFollowed_m);
    const double change_m = kSteepest * way_m;
    if (std::abs(above_m) > change_m + kGroundNoise_m) return above_m;
    last_m_ = point.range_m;
    height_m_ += std::clamp(above_m, -change_m, change_m);
    return point.height_m - height_m_;
  }

 private:
  double height_m_ = 0.0;
  bool isFollowed_;
  /// Range where the ground was seen last; up to where it is seen first it is the plane.
  double last_m_ = std::numeric_limits<double>::infinity();
};

/// How far nothing is in the way. Sorts what was measured.
double freeRange_m(std::vector<Measured>& points, bool isGroundFollowed, const FloorPlanOptions& options) {
  std::sort(points.begin(), points.end(), [](const Measured& a, const Measured& b) {
    return a.range_m < b.range_m || (a.range_m == b.range_m && a.height_m < b.height_m);
  });
  GroundProfile ground(isGroundFollowed);
  double farthest_m = 0.0;
  double before_m = 0.0;  // where the ground was seen before it fell off
  std::size_t obstacles = 0;
  std::size_t drops = 0;
  for (const Measured& point : points) {
    const double height_m = ground.heightOver_m(point);
    if (height_m > options.max_height_m) continue;
    if (isGroundFollowed && height_m < -options.min_height_m) {
      if (++drops == kBlockingPoints) return before_m;
      continue;
    }
    if (height_m >= options.min_height_m && ++obstacles == kBlockingPoints) return point.range_m;
    farthest_m = point.range_m;
    if (drops == 0 && height_m < options.min_height_m) before_m = point.range_m;
  }
  return farthest_m;
}

/// Directions over a half circle around where the camera looks.
class Panorama {
 public:
  explicit Panorama(const Eigen::Isometry3d& T_ground_cam)
      : directions_(static_cast<std::size_t>(std::lround(M_PI / kFanDirection_rad))) {
    // A camera that looks straight down has no heading but the one of its image's upper edge.
    const Eigen::Vector3d ahead = T_ground_cam.linear() * Eigen::Vector3d(0.0, -0.1, 1.0);
    heading_rad_ = std::atan2(ahead.y(), ahead.x());
  }

  void add(const Eigen::Vector3d& p_ground_m) {
    const double bearing_rad = std::remainder(std::atan2(p_ground_m.y(), p_ground_m.x()) - heading_rad_, 2.0 * M_PI);
    const double index = (M_PI / 2.0 - bearing_rad) / kFanDirection_rad;
    if (!(index >= 0.0 && index < static_cast<double>(directions_.size()))) return;
    directions_[static_cast<std::size_t>(index)].push_back({p_ground_m.head<2>().norm(), p_ground_m.z()});
  }

  /// From left to right.
  [[nodiscard]] std::vector<Eigen::Vector2d> freeOffsets_m(bool isGroundFollowed, const FloorPlanOptions& options) {
    std::vector<Eigen::Vector2d> offsets;
    for (std::size_t i = 0; i < directions_.size(); ++i) {
      const double range_m = std::min(freeRange_m(directions_[i], isGroundFollowed, options), options.max_range_m);
      if (range_m <= 0.0) continue;
      const double angle_rad = heading_rad_ + M_PI / 2.0 - (static_cast<double>(i) + 0.5) * kFanDirection_rad;
      offsets.emplace_back(range_m * std::cos(angle_rad), range_m * std::sin(angle_rad));
    }
    return offsets;
  }

 private:
  double heading_rad_ = 0.0;
  std::vector<std::vector<Measured>> directions_;
};

}  // namespace

std::vector<Eigen::Vector3f> freeFan(const cv::Mat& depth_m, const core::CameraModel& camera,
                                     const StandingGround& ground, const FloorPlanOptions& options) {
  const Eigen::Isometry3d T_ground_cam = ground.plane.T_ground_cam();
  Panorama panorama(T_ground_cam);
  for (const DepthPoint& point : depthPoints(depth_m, camera, kStep_px)) panorama.add(T_ground_cam * point.p_cam_m);
  std::vector<Eigen::Vector3f> fan_cam_m;
  for (const Eigen::Vector2d& offset_m : panorama.freeOffsets_m(ground.isSeen, options)) {
    const Eigen::Vector3d atEyeLevel_m(offset_m.x(), offset_m.y(), 0.0);
    fan_cam_m.emplace_back((T_ground_cam.linear().transpose() * atEyeLevel_m).cast<float>());
  }
  return fan_cam_m;
}

}  // namespace wardslam::mapping
