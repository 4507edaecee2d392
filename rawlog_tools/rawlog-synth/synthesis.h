#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

#include "kinect_noise.h"
#include "scene_builder.h"
#include "wardslam/core/camera_model.h"

namespace wardslam::synth {

enum class Place { Ward, Floor };

struct SynthesisOptions {
  Place place = Place::Ward;
  std::optional<double> seconds;  ///< Unless told: 20 s of the ward, one round of the floor.
  double rate_hz = 30.0;
  int width_px = 640;
  int height_px = 480;
  SceneOptions scene;
  KinectOptions sensor;
  std::optional<double> stereoBaseline_m;  ///< A second camera so far to the right instead of depth.
};

constexpr double kFirstStamp_s = 1700000000.0;

/// A camera with the Kinect's field of view.
[[nodiscard]] core::CameraModel cameraFor(int width_px, int height_px);

[[nodiscard]] std::size_t frameCount(const SynthesisOptions& options);

/// Renders the place and writes `rawlog` and what goes with it (SequenceWriter). `goOn` is asked after every frame,
/// with the number of frames done; when it says no, what has been rendered is finished as a shorter sequence.
/// Returns the number of frames. The same options give the same bytes. Throws core::InputError.
std::size_t synthesise(const std::filesystem::path& rawlog, const SynthesisOptions& options,
                       const std::function<bool(std::size_t)>& goOn);

}  // namespace wardslam::synth
