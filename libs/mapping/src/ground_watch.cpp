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
  auto seeing = std::make_shared<odometry::Keyframe>(*keyframe);
  seeing->ground = ground;
  return seeing;
}

/// Tracked without a gap, one keyframe is known from the other; else what was known of the ground is not.
void GroundWatch::carryTo(const odometry::Keyframe& keyframe) {
  if (keyframe.submap != submap_) last_.reset();
  submap_ = keyframe.submap;
  if (!last_) return;
  last_ = last_->seenFrom(keyframe.T_previous_cam.inverse());
  way_m_ += keyframe.T_previous_cam.translation().norm();
}

}  // namespace wardslam::mapping
