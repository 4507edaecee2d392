#include <CLI/CLI.hpp>
#include <iostream>
#include <optional>
#include <string>

#include "arguments/arguments.h"
#include "support/command_line.h"
#include "support/interruption.h"
#include "support/program.h"
#include "support/progress.h"
#include "synthesis/synthesis.h"

namespace {

using namespace wardslam;

int synthesise(const synth::SynthesisOptions& options) {
  const apps::InterruptionGuard interruption;
  std::optional<apps::Progress> progress;
  std::size_t total = 0;
  const std::size_t done = synth::synthesise(options, [&](std::size_t frames, std::size_t ofFrames) {
    if (!progress) progress.emplace(std::cerr, apps::standardErrorIsTerminal(), "frame", total = ofFrames);
    progress->update(frames);
    return !interruption.requested();
  });
  if (done == total) return apps::kSuccess;
  std::cerr << "rawlog-synth: interrupted; " << options.output.file.string() << " holds the first " << done << " of "
            << total << " frames\n";
  return apps::kFailure;
}

}  // namespace

int main(int argc, char** argv) {
  return apps::runProgram("rawlog-synth", [&]() -> int {
    CLI::App app(
        "Renders a hospital with walking people as an RGB-D or stereo rawlog with exact ground truth and labels",
        "rawlog-synth");
    app.set_version_flag("--version", "rawlog-synth " WARDSLAM_VERSION);
    synth::SynthesisOptions options;
    synth::declareOutput(app, options.output);
    synth::declarePlace(app, options.place);
    synth::declareHospital(app, options.place.hospital);
    synth::declareCamera(app, options.camera);
    synth::declareSensor(app, options.sensor);
    if (const auto code = apps::parseCommandLine(app, argc, argv)) return *code;
    if (const std::string fault = synth::settleOutput(options); !fault.empty()) throw apps::UsageError(fault);
    if (options.sensor.odometry || options.sensor.imu) options.camera.isMountStated = true;
    return synthesise(options);
  });
}
