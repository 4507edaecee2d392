#pragma once

#include <string>

#include "synthesis/synthesis.h"

namespace CLI {  // NOLINT(readability-identifier-naming)
class App;
}

/// What the command line offers, by purpose; each group in a file of its own.
namespace wardslam::synth {

void declarePlace(CLI::App& app, PlaceOptions& options);
void declareHospital(CLI::App& app, HospitalOptions& options);
void declareCamera(CLI::App& app, CameraOptions& options);
void declareSensor(CLI::App& app, SensorOptions& options);
void declareOutput(CLI::App& app, OutputOptions& options);

/// Once all is parsed: decides what kind of output was meant. Returns what is wrong with it, empty if nothing.
[[nodiscard]] std::string settleOutput(SynthesisOptions& options);

}  // namespace wardslam::synth
