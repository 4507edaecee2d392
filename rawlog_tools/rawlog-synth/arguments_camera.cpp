#include <CLI/CLI.hpp>

#include "arguments.h"

namespace wardslam::synth {

void declareCamera(CLI::App& app, CameraOptions& options) {
  app.option_defaults()->group("Camera");
  app.add_option("--rate", options.rate_hz, "pictures per second")
      ->check(CLI::Range(0.1, 120.0))
      ->capture_default_str();
  app.add_option("--width", options.width_px, "image width, px")->check(CLI::Range(64, 2048))->capture_default_str();
  app.add_option("--height", options.height_px, "image height, px")->check(CLI::Range(48, 2048))->capture_default_str();
  app.add_option("--stereo", options.stereoBaseline_m,
                 "a rectified stereo camera instead of an RGB-D camera; its baseline, m (0.12 without a number)")
      ->expected(0, 1)
      ->default_str("0.12")
      ->check(CLI::Range(0.01, 2.0));
}

}  // namespace wardslam::synth
