#include "wardslam/mapping/ground_watch.h"

#include "known_ground.h"
#include "wardslam/mapping/floor_finder.h"

namespace wardslam::mapping {

std::shared_ptr<const odometry::Keyframe> GroundWatch::look(const std::shared_ptr<const odometry::Keyframe>& keyframe,
                                                            const cv::Mat& depth_m) {
  carryTo(*keyframe);
  PlacedKeyframe here;
  here.T_map_cam = keyframe->T_map_cam;
  const auto known = last_ ? std::optional(KnownGround{*last_, way_m_}) : std::nullopt;
  const auto ground = findGround(depth_m, keyframe->camera, expectedAt(here, known));
  if (!ground) return keyframe;
  last_ = ground;
  way_m_ = 0.0;
  up_map_ += keyframe->T_map_cam.linear() * ground->normal_cam;
  ground_map_m_ = keyframe->T_map_cam * (-ground->height_m * ground->normal_cam);
  auto seeing = std::make_shared<odometry::Keyframe>(*keyframe);
  seeing->ground = ground;
  return seeing;
}

Eigen::Isometry3d GroundWatch::placeAnew(const Eigen::Isometry3d& T_map_cam, const core::CameraModel& camera,
                                         const cv::Mat& depth_m) const {
  if (up_map_.isZero()) return T_map_cam;
  Eigen::Isometry3d T_floor_map(Eigen::Quaterniond::FromTwoVectors(up_map_, Eigen::Vector3d::UnitZ()));
  T_floor_map.pretranslate(Eigen::Vector3d(0.0, 0.0, -(T_floor_map * ground_map_m_).z()));
  const auto T_floor_cam = levelWithFloor(depth_m, camera, T_floor_map * T_map_cam);
  return T_floor_cam ? T_floor_map.inverse() * *T_floor_cam : T_map_cam;
}

void GroundWatch::follow(const Eigen::Isometry3d& correction) {
  up_map_ = correction.linear() * up_map_;
  ground_map_m_ = correction * ground_map_m_;
}

/// Tracked without a gap, one keyframe is known from the other; else what was known of the ground is not.
void GroundWatch::carryTo(const odometry::Keyframe& keyframe) {
  if (keyframe.submap != submap_ || !keyframe.T_previous_cam) last_.reset();
  submap_ = keyframe.submap;
  if (!last_) return;
  last_ = last_->seenFrom(keyframe.T_previous_cam->inverse());
  way_m_ += keyframe.T_previous_cam->translation().norm();
}

}  // namespace wardslam::mapping
