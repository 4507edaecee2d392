#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <map>
#include <string>

#include "support/command_line.h"
#include "support/interruption.h"
#include "support/program.h"
#include "support/progress.h"
#include "synthesis.h"

namespace {

using namespace wardslam;

struct Arguments {
  std::filesystem::path output;
  synth::SynthesisOptions options;
};

void declare(CLI::App& app, Arguments& arguments) {
  auto& options = arguments.options;
  app.add_option("-o,--output", arguments.output,
                 "FILE.rawlog to write; FILE.groundtruth.txt and FILE_labels/ go beside it")
      ->required()
      ->check([](const std::string& file) {
        return std::filesystem::path(file).extension() == ".rawlog" ? std::string() : "must end in .rawlog";
      });
  app.add_option("--scene", options.place,
                 "ward: one room; floor: two rooms and a corridor, one round of 41 m a minute")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, synth::Place>{{"ward", synth::Place::Ward}, {"floor", synth::Place::Floor}}));
  app.add_option("--seconds", options.seconds, "how long it lasts; unless told 20 s of the ward, a round of the floor")
      ->check(CLI::Range(0.01, 3600.0));
  app.add_option("--rate", options.rate_hz, "pictures per second")
      ->check(CLI::Range(0.1, 120.0))
      ->capture_default_str();
  app.add_option("--seed", options.scene.seed, "another seed, another place: textures, furniture, noise")
      ->capture_default_str();
  app.add_flag_callback(
      "--no-people", [&options] { options.scene.people = false; },
      "nobody there; in the ward the trolley stands where it would be left");
  app.add_option("--width", options.width_px, "image width, px")->check(CLI::Range(64, 2048))->capture_default_str();
  app.add_option("--height", options.height_px, "image height, px")->check(CLI::Range(48, 2048))->capture_default_str();
  app.add_option("--stereo", options.stereoBaseline_m,
                 "a rectified stereo camera instead of an RGB-D camera; its baseline, m (0.12 without a number)")
      ->expected(0, 1)
      ->default_str("0.12")
      ->check(CLI::Range(0.01, 2.0));
  app.add_option("--depth-noise", options.sensor.depthNoise, "times a Kinect's depth noise; 0 = perfect depth")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  app.add_option("--image-noise", options.sensor.imageNoise, "standard deviation, grey levels")
      ->check(CLI::Range(0.0, 50.0))
      ->capture_default_str();
  app.add_option("--vignetting", options.sensor.vignetting, "loss of light in the corners, 0 to 1")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
}

int synthesise(const Arguments& arguments) {
  const std::size_t total = synth::frameCount(arguments.options);
  const apps::InterruptionGuard interruption;
  apps::Progress progress(std::cerr, apps::standardErrorIsTerminal(), "frame", total);
  const std::size_t done = synth::synthesise(arguments.output, arguments.options, [&](std::size_t frames) {
    progress.update(frames);
    return !interruption.requested();
  });
  if (done == total) return apps::kSuccess;
  std::cerr << "rawlog-synth: interrupted; " << arguments.output.string() << " holds the first " << done << " of "
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
    Arguments arguments;
    declare(app, arguments);
    if (const auto code = apps::parseCommandLine(app, argc, argv)) return *code;
    return synthesise(arguments);
  });
}
