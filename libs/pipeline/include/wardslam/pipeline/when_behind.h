#pragma once

namespace wardslam::pipeline {

/// What becomes of images that come faster than they can be worked into the map.
enum class WhenBehind {
  LeavesViewsOut,  ///< A camera does not wait: views that are no keyframes are left out, and counted.
  Waits,           ///< A recording does: everything is worked in, and the map only a few keyframes behind the camera.
};

}  // namespace wardslam::pipeline
