#pragma once

#include "synthesis.h"

namespace CLI {  // NOLINT(readability-identifier-naming)
class App;
}

/// What the command line offers, by purpose; each group in a file of its own.
namespace wardslam::synth {

void declarePlace(CLI::App& app, PlaceOptions& options);
void declareCamera(CLI::App& app, CameraOptions& options);
void declareSensor(CLI::App& app, SensorOptions& options);
void declareOutput(CLI::App& app, OutputOptions& options);

}  // namespace wardslam::synth
