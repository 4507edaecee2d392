#pragma once

#include <cstddef>
#include <functional>

#include "camera/camera_options.h"
#include "output/output_options.h"
#include "places/place.h"
#include "sensors/sensor_options.h"

namespace wardslam::synth {

/// What is to be rendered, with what, and into what.
struct SynthesisOptions {
  PlaceOptions place;
  CameraOptions camera;
  SensorOptions sensor;
  OutputOptions output;
};

/// Stamp of the first picture (UNIX s): of every day that day's, of one robot after the other an hour later.
[[nodiscard]] double firstStamp_s(const PlaceOptions& place);

/// Seconds after the start, such that stamps are whole microseconds.
[[nodiscard]] double timeOf(std::size_t frame, double rate_hz);

/// Renders the place and writes it (SequenceWriter). `goOn` is asked after every frame, with the number of frames done
/// and of all; when it says no, what has been rendered is finished as a shorter sequence. Returns the number of frames.
/// The same options give the same bytes. Throws core::InputError.
std::size_t synthesise(const SynthesisOptions& options, const std::function<bool(std::size_t, std::size_t)>& goOn);

}  // namespace wardslam::synth
