#pragma once

#include <filesystem>
#include <string>

namespace wardslam::test {

/// What the virtual camera is and does, read from a file of lines "key = value" that may be changed while it runs.
struct CameraSettings {
  enum class State { Plugged, Unplugged, Silent };
  enum class Infrared { CannotStart, Absent };

  std::filesystem::path folder;  ///< `folder`: images in TUM's layout, shown to and fro.
  double rate_hz = 30.0;         ///< `rate`
  int width_px = 640;            ///< `width`, `height`: of the images; the mode offered is always 640x480 …
  int height_px = 480;
  int mode_width_px = 640;  ///< … unless `mode_width` and `mode_height` say otherwise.
  int mode_height_px = 480;
  double focal_length_px = 525.0;             ///< `focal_length`
  Infrared infrared = Infrared::CannotStart;  ///< `infrared = cannot_start | absent`
  State state = State::Plugged;               ///< `state = plugged | unplugged | silent`
};

/// Unknown keys are ignored; a file that is absent is an unplugged camera.
[[nodiscard]] CameraSettings readCameraSettings(const std::filesystem::path& file);

}  // namespace wardslam::test
