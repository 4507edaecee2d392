#pragma once

#include <functional>
#include <optional>
#include <string>

#include "wardslam/pipeline/frame_observer.h"

namespace wardslam::apps {

/// Tells, once each and while it happens, of a camera whose depth or whole image stands still.
class StillCamera : public pipeline::FrameObserver {
 public:
  explicit StillCamera(std::function<void(const std::string&)> tell) : tell_(std::move(tell)) {}

  void onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) override;

 private:
  std::function<void(const std::string&)> tell_;
  double lastChange_s_ = 0.0;
  bool toldOfDepth_ = false;
  bool toldOfImage_ = false;
};

}  // namespace wardslam::apps
