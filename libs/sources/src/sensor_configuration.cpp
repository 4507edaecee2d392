#include "wardslam/sources/sensor_configuration.h"

#include <mrpt/config/CConfigFile.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "wardslam/core/errors.h"
#include "wardslam/core/nearest_name.h"

namespace wardslam::sources {
namespace {

using mrpt::config::CConfigFileBase;
using Names = std::vector<std::string>;

constexpr const char* kGlobalSection = "global";

/// What drivers do not work without although they do not say so.
const Names& requiredKeys(const std::string& driver) {
  static const std::map<std::string, Names> kKeys = {{"COpenNI2Sensor", {"width", "height", "fps"}}};
  static const Names kNone;
  const auto keys = kKeys.find(driver);
  return keys == kKeys.end() ? kNone : keys->second;
}

std::string joined(const Names& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

Names sectionsOf(const CConfigFileBase& ini) {
  Names sections;
  ini.getAllSections(sections);
  sections.erase(std::remove(sections.begin(), sections.end(), kGlobalSection), sections.end());
  return sections;
}

/// Also one that rawlog-grabber ignores, as the camera of another sensor is.
std::string namedSection(const CConfigFileBase& ini, const std::filesystem::path& file, const std::string& name) {
  if (ini.sectionExists(name)) return name;
  throw core::InputError(file.string() + ": has no sensor [" + name + "]; did you mean [" +
                         core::nearestName(name, sectionsOf(ini)) + "]?");
}

std::string onlySection(const CConfigFileBase& ini, const std::filesystem::path& file) {
  Names sections = sectionsOf(ini);
  const auto isNoSensor = [&](const std::string& section) {
    return section.empty() || ini.read_bool(section, "rawlog-grabber-ignore", false);
  };
  sections.erase(std::remove_if(sections.begin(), sections.end(), isNoSensor), sections.end());
  if (sections.empty()) throw core::InputError(file.string() + ": holds no section for a sensor, like [OPENNI2]");
  if (sections.size() == 1) return sections.front();
  throw core::InputError(file.string() + ": holds several sensors (" + joined(sections) + "); say which with --sensor");
}

void requireKey(const CConfigFileBase& ini, const SensorConfiguration& sensor, const std::string& key) {
  if (ini.keyExists(sensor.section, key)) return;
  Names keys;
  ini.getAllKeys(sensor.section, keys);
  const std::string nearest = core::nearestName(key, keys);
  throw core::InputError(sensor.place + ": the key '" + key + "' is missing" +
                         (nearest.empty() ? "" : " (the nearest one there is '" + nearest + "')"));
}

/// MRPT throws where its macros ("$env{", "$eval{") have no end, a headline first.
mrpt::config::CConfigFile openIni(const std::filesystem::path& file) {
  try {
    return mrpt::config::CConfigFile(file.string());
  } catch (const std::exception& error) {
    std::istringstream text(error.what());
    std::string what;
    while (what.empty() || what.front() == '=') {
      if (!std::getline(text, what)) break;
    }
    throw core::InputError(file.string() + ": is no .ini file that can be read: " + what);
  }
}

}  // namespace

SensorConfiguration readSensorConfiguration(const std::filesystem::path& file, const std::string& section) {
  if (!std::filesystem::is_regular_file(file)) throw core::InputError(file.string() + ": no such file");
  return readSensorConfiguration(openIni(file), file, section);
}

SensorConfiguration readSensorConfiguration(const CConfigFileBase& ini, const std::filesystem::path& file,
                                            const std::string& section) {
  SensorConfiguration sensor;
  sensor.file = file;
  sensor.section = section.empty() ? onlySection(ini, file) : namedSection(ini, file, section);
  sensor.place = file.string() + ": [" + sensor.section + "]";
  requireKey(ini, sensor, "driver");
  sensor.driver = ini.read_string(sensor.section, "driver", "");
  requireKey(ini, sensor, "process_rate");
  sensor.process_rate_hz = ini.read_double(sensor.section, "process_rate", 0.0);
  if (!(sensor.process_rate_hz > 0.0)) {
    throw core::InputError(sensor.place + ": process_rate must be a number of Hz above 0");
  }
  for (const std::string& key : requiredKeys(sensor.driver)) requireKey(ini, sensor, key);
  return sensor;
}

bool isSensorConfiguration(const std::filesystem::path& input) {
  return input.extension() == ".ini" && !std::filesystem::is_directory(input);
}

}  // namespace wardslam::sources
