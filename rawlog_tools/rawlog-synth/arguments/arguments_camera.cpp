#include <CLI/CLI.hpp>
#include <string>

#include "arguments/arguments.h"
#include "arguments/one_of.h"
#include "arguments/within.h"

namespace wardslam::synth {

namespace {

constexpr double kDegree_rad = 0.017453292519943295;

void declareMount(CLI::App& app, CameraOptions& options) {
  const auto statedAngle = [&options](double& target_rad) {
    return [&](const double& angle_deg) {
      target_rad = angle_deg * kDegree_rad;
      options.isMountStated = true;
    };
  };
  app.add_option_function<double>(
         "--camera-height",
         [&options](const double& height_m) {
           options.mount.height_m = height_m;
           options.isMountStated = true;
         },
         "metres over the floor (1.1)")
      ->check(within(0.1, 2.5));
  app.add_option_function<double>("--camera-pitch", statedAngle(options.mount.pitch_rad),
                                  "how far it looks down, degrees (5.73)")
      ->check(within(-80.0, 80.0));
  app.add_option_function<double>("--camera-roll", statedAngle(options.mount.roll_rad),
                                  "how far it leans to the right, degrees (0)")
      ->check(within(-180.0, 180.0));
}

}  // namespace

void declareCamera(CLI::App& app, CameraOptions& options) {
  app.option_defaults()->group("Camera");
  app.add_option("--rate", options.rate_hz, "pictures per second")->check(within(0.1, 120.0))->capture_default_str();
  app.add_option("--width", options.width_px, "image width, px")->check(CLI::Range(64, 2048))->capture_default_str();
  app.add_option("--height", options.height_px, "image height, px")->check(CLI::Range(48, 2048))->capture_default_str();
  app.add_option("--stereo", options.stereoBaseline_m,
                 "a rectified stereo camera instead of an RGB-D camera; its baseline, m (0.12 without a number)")
      ->expected(0, 1)
      ->default_str("0.12")
      ->check(within(0.01, 2.0));
  app.add_option("--lens", options.lens, "none: a pinhole; kinect: a real one's distortion; wide: barrel, k1 = -0.28")
      ->type_name("TEXT")
      ->transform(oneOf<Lens>({{"none", Lens::None}, {"kinect", Lens::Kinect}, {"wide", Lens::Wide}}));
  declareMount(app, options);
}

}  // namespace wardslam::synth
