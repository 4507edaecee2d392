#pragma once

#include "wardslam/core/frame.h"
#include "wardslam/odometry/odometry.h"

namespace wardslam::pipeline {

/// Hears of every frame a SlamSystem has finished, in order, in the thread that calls process().
class FrameObserver {
 public:
  virtual ~FrameObserver() = default;
  virtual void onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) = 0;
};

}  // namespace wardslam::pipeline
