#pragma once

#include <memory>

#include "wardslam/core/label_space.h"
#include "wardslam/pipeline/frame_observer.h"

namespace wardslam::viewer {

/// Shows a run as it goes, in a window: the annotated image, and in the map frame what the camera sees now (what moves
/// in red) and the way it came. Draws a few times a second, whatever the rate of the frames; once the window is closed
/// the run goes on without it.
class LiveWindow : public pipeline::FrameObserver {
 public:
  /// Throws core::InputError where there is no display.
  explicit LiveWindow(const core::LabelSpace& labels);
  ~LiveWindow() override;

  void onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) override;

 private:
  struct Window;
  core::LabelSpace labels_;
  std::unique_ptr<Window> window_;
};

}  // namespace wardslam::viewer
