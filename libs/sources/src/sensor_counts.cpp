#include "wardslam/sources/sensor_counts.h"

namespace wardslam::sources {

std::string SensorCounts::labels() const {
  std::string text;
  for (const auto& [label, count] : observations) text += (text.empty() ? "" : ", ") + label;
  return text;
}

std::optional<std::string> SensorCounts::sentence() const {
  if (observations.size() < 2) return std::nullopt;
  std::string text;
  for (const auto& [label, count] : observations) {
    text += (text.empty() ? "" : ", ") + label + " (" + std::to_string(count) + ")";
  }
  return "has RGB-D observations of several sensors, " + text + "; those of " + taken +
         " are taken, --sensor LABEL chooses another";
}

}  // namespace wardslam::sources
