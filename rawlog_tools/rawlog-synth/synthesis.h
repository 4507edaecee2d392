#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "camera_path.h"
#include "kinect_noise.h"
#include "ward_scene.h"
#include "wardslam/core/camera_model.h"

namespace wardslam::synth {

struct SynthesisOptions {
  double seconds = 20.0;
  double rate_hz = 30.0;
  int width_px = 640;
  int height_px = 480;
  WardOptions ward;
  KinectOptions sensor;
};

constexpr double kFirstStamp_s = 1700000000.0;

/// A camera with the Kinect's field of view.
[[nodiscard]] core::CameraModel cameraFor(int width_px, int height_px);

[[nodiscard]] std::size_t frameCount(const SynthesisOptions& options);

/// Renders the ward and writes `rawlog` and what goes with it (SequenceWriter). `goOn` is asked after every frame,
/// with the number of frames done; when it says no, what has been rendered is finished as a shorter sequence.
/// Returns the number of frames. The same options give the same bytes. Throws core::InputError.
std::size_t synthesise(const std::filesystem::path& rawlog, const SynthesisOptions& options,
                       const std::function<bool(std::size_t)>& goOn);

}  // namespace wardslam::synth
