#include "camera_settings.h"

#include <fstream>
#include <map>

namespace wardslam::test {
namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::map<std::string, std::string> readEntries(const std::filesystem::path& file) {
  std::map<std::string, std::string> entries;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const auto equals = line.find('=');
    if (equals != std::string::npos) entries[trimmed(line.substr(0, equals))] = trimmed(line.substr(equals + 1));
  }
  return entries;
}

CameraSettings::State stateOf(const std::string& name) {
  if (name == "unplugged") return CameraSettings::State::Unplugged;
  return name == "silent" ? CameraSettings::State::Silent : CameraSettings::State::Plugged;
}

}  // namespace

CameraSettings readCameraSettings(const std::filesystem::path& file) {
  CameraSettings settings;
  auto entries = readEntries(file);
  if (entries.empty()) settings.state = CameraSettings::State::Unplugged;
  const auto number = [&](const std::string& key, auto& value) {
    if (entries.count(key) > 0) value = static_cast<std::decay_t<decltype(value)>>(std::stod(entries[key]));
  };
  settings.folder = entries["folder"];
  number("rate", settings.rate_hz);
  number("width", settings.width_px);
  number("height", settings.height_px);
  number("mode_width", settings.mode_width_px);
  number("mode_height", settings.mode_height_px);
  number("focal_length", settings.focal_length_px);
  if (entries["infrared"] == "absent") settings.infrared = CameraSettings::Infrared::Absent;
  if (entries.count("state") > 0) settings.state = stateOf(entries["state"]);
  return settings;
}

}  // namespace wardslam::test
