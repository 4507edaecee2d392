#pragma once

#include "wardslam/core/frame.h"
#include "wardslam/odometry/map_update.h"
#include "wardslam/odometry/odometry.h"

namespace wardslam::pipeline {

/// Hears of every frame a SlamSystem has finished, in order, in the thread that calls process().
class FrameObserver {
 public:
  virtual ~FrameObserver() = default;
  virtual void onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) = 0;
  /// What the map found out of keyframes of earlier frames; between frames, and in SlamSystem::finish().
  virtual void onUpdate(const odometry::MapUpdate& /*update*/) {}
};

}  // namespace wardslam::pipeline
