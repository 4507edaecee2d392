#include <CLI/CLI.hpp>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "arguments/arguments.h"
#include "arguments/one_of.h"
#include "arguments/within.h"

namespace wardslam::synth {

namespace {

void declareExposure(CLI::App& app, ExposureOptions& options) {
  app.add_flag("--dark", options.isDark, "the light is off: colours are all but black, depth stays");
  app.add_flag("--exposure-jumps", options.jumps, "every few seconds automatic exposure finds another brightness");
  app.add_option("--motion-blur", options.motionBlur_ms, "how long the shutter is open, ms")->check(within(0.0, 200.0));
}

std::string sentenceAgainstCover(const std::string& text) {
  try {
    static_cast<void>(parseCover(text));
    return {};
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

void declareMishaps(CLI::App& app, MishapOptions& options) {
  app.add_option_function<std::vector<std::string>>(
         "--cover",
         [&options](const std::vector<std::string>& texts) {
           for (const std::string& text : texts) options.covers.push_back(parseCover(text));
         },
         "FROM:SECONDS, a hand over the lens; as often as wanted")
      ->check(CLI::Validator(sentenceAgainstCover, "FROM:SECONDS"));
  app.add_option("--drop", options.lostShare, "part of the frames that the recorder loses, in bursts, 0 to 0.9")
      ->check(within(0.0, 0.9));
}

/// An option with an optional rate that switches a sensor on.
template <class Options>
void declareMotionSensor(CLI::App& app, std::optional<Options>& sensor, const std::string& name,
                         const std::string& what, double most_hz) {
  const double usual_hz = Options{}.rate_hz;
  std::ostringstream rate;
  rate << usual_hz;
  auto* option = app.add_option_function<double>(
      "--" + name,
      [&sensor](const double& rate_hz) {
        if (!sensor) sensor.emplace();
        sensor->rate_hz = rate_hz;
      },
      what + "; its rate, Hz (" + rate.str() + " without a number)");
  option->expected(0, 1)->default_str(rate.str())->check(within(1.0, most_hz));
  app.add_option_function<double>(
         "--" + name + "-noise",
         [&sensor](const double& noise) {
           if (!sensor) sensor.emplace();
           sensor->noise = noise;
         },
         "times the usual errors of --" + name + "; 0 = none")
      ->needs(option)
      ->check(within(0.0, 100.0));
}

}  // namespace

void declareSensor(CLI::App& app, SensorOptions& options) {
  app.option_defaults()->group("Sensor");
  app.add_option(
         "--depth-sensor", options.depth,
         "kinect: structured light; tof: time of flight; stereo: active stereo; perfect: the truth within range")
      ->type_name("TEXT")
      ->transform(oneOf<DepthSensor>({{"kinect", DepthSensor::Kinect},
                                      {"tof", DepthSensor::Tof},
                                      {"stereo", DepthSensor::Stereo},
                                      {"perfect", DepthSensor::Perfect}}));
  app.add_option("--depth-noise", options.kinect.depthNoise, "times the sensor's depth noise; 0 = perfect depth")
      ->check(within(0.0, 10.0))
      ->capture_default_str();
  app.add_option("--image-noise", options.kinect.imageNoise, "standard deviation, grey levels")
      ->check(within(0.0, 50.0))
      ->capture_default_str();
  app.add_option("--vignetting", options.kinect.vignetting, "loss of light in the corners, 0 to 1")
      ->check(within(0.0, 1.0))
      ->capture_default_str();
  declareExposure(app, options.exposure);
  declareMishaps(app, options.mishaps);
  declareMotionSensor(app, options.odometry, "odometry", "what the wheels say, with slip and drift", 1000.0);
  declareMotionSensor(app, options.imu, "imu", "an inertial sensor in the camera's housing", 2000.0);
}

}  // namespace wardslam::synth
