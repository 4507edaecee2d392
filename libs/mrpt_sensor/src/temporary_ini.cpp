#include "temporary_ini.h"

#include <mrpt/config/CConfigFileBase.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

#include "wardslam/core/errors.h"

namespace wardslam::mrpt_sensor {
namespace {

std::filesystem::path makeEmptyFile() {
  constexpr const char* kEnding = ".ini";
  std::string name = (std::filesystem::temp_directory_path() / "wardslam_sensor_XXXXXX").string() + kEnding;
  const int file = mkstemps(name.data(), static_cast<int>(std::char_traits<char>::length(kEnding)));
  if (file < 0) throw core::InputError(name + ": cannot be made; is there room in the folder for temporary files?");
  close(file);
  return name;
}

}  // namespace

TemporaryIni::TemporaryIni(const mrpt::config::CConfigFileBase& ini) : path_(makeEmptyFile()) {
  std::ofstream out(path_);
  std::vector<std::string> sections;
  ini.getAllSections(sections);
  for (const std::string& section : sections) {
    out << "[" << section << "]\n";
    std::vector<std::string> keys;
    ini.getAllKeys(section, keys);
    for (const std::string& key : keys) out << key << " = " << ini.read_string(section, key, "") << "\n";
  }
}

TemporaryIni::~TemporaryIni() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

}  // namespace wardslam::mrpt_sensor
