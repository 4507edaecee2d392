#include <CLI/CLI.hpp>

#include "arguments.h"

namespace wardslam::synth {

void declareSensor(CLI::App& app, SensorOptions& options) {
  app.option_defaults()->group("Sensor");
  app.add_option("--depth-noise", options.kinect.depthNoise, "times a Kinect's depth noise; 0 = perfect depth")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  app.add_option("--image-noise", options.kinect.imageNoise, "standard deviation, grey levels")
      ->check(CLI::Range(0.0, 50.0))
      ->capture_default_str();
  app.add_option("--vignetting", options.kinect.vignetting, "loss of light in the corners, 0 to 1")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
}

}  // namespace wardslam::synth
