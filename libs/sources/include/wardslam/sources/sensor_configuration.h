#pragma once

#include <filesystem>
#include <string>

namespace mrpt::config {
class CConfigFileBase;
}

namespace wardslam::sources {

/// One sensor of a configuration file of rawlog-grabber (.ini).
struct SensorConfiguration {
  std::filesystem::path file;
  std::string section;           ///< "OPENNI2"
  std::string driver;            ///< MRPT class derived from CGenericSensor: "COpenNI2Sensor".
  double process_rate_hz = 0.0;  ///< How often the driver is asked for observations.
  std::string place;             ///< "config/sensors/openni2.ini: [OPENNI2]", to begin sentences with.
};

/// The sensor in this section; where `section` is empty, the only one of the file. [global] and sections with
/// rawlog-grabber-ignore are no sensors. Throws core::InputError naming file, section, key and the nearest valid name.
[[nodiscard]] SensorConfiguration readSensorConfiguration(const std::filesystem::path& file,
                                                          const std::string& section = {});

/// The same from what was read already; `file` is only noted.
[[nodiscard]] SensorConfiguration readSensorConfiguration(const mrpt::config::CConfigFileBase& ini,
                                                          const std::filesystem::path& file,
                                                          const std::string& section = {});

/// Whether a path means a live sensor: a configuration file (.ini), not a recording.
[[nodiscard]] bool isSensorConfiguration(const std::filesystem::path& input);

}  // namespace wardslam::sources
