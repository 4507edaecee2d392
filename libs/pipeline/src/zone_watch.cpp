#include "wardslam/pipeline/zone_watch.h"

#include <utility>

namespace wardslam::pipeline {

ZoneWatch::ZoneWatch(mapping::Zones zones, OnEnter onEnter) : zones_(std::move(zones)), onEnter_(std::move(onEnter)) {}

void ZoneWatch::onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) {
  if (!odometry.hasPose() || !odometry.isInMap) {
    last_.reset();
    return;
  }
  const Eigen::Vector2d p_map_m = odometry.T_map_cam.translation().head<2>();
  const Place here{frame.stamp_s, p_map_m, zones_.at(p_map_m)};
  ZoneStay& stay = stays_[here.zone];
  if (last_) {
    stay.time_s += here.stamp_s - last_->stamp_s;
    stay.distance_m += (here.p_map_m - last_->p_map_m).norm();
  }
  if (here.zone != zone_ || stay.entries == 0) {
    ++stay.entries;
    if (onEnter_ && here.zone != zone_) onEnter_(zone_, here.zone, here.stamp_s);
  }
  zone_ = here.zone;
  last_ = here;
}

}  // namespace wardslam::pipeline
