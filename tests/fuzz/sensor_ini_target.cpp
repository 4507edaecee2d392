#include <mrpt/config/CConfigFile.h>
#include <yaml-cpp/yaml.h>

#include "fuzz_input.h"
#include "wardslam/core/ini_section.h"
#include "wardslam/sources/sensor_configuration.h"

// A sensor's configuration of rawlog-grabber, and a section of it laid over options.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wardslam;
  const auto file = fuzz::scratch().write("sensor.ini", data, size);
  fuzz::mayRefuse([&] {
    const auto sensor = sources::readSensorConfiguration(file);
    const mrpt::config::CConfigFile ini(file.string());
    YAML::Node root;
    core::overlay(root, ini, sensor.section, {"driver"});
  });
  return 0;
}
