#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace wardslam::sources {

/// The RGB-D observations of a recording, by the label of the sensor that made them.
struct SensorCounts {
  std::map<std::string, std::size_t> observations;
  std::string taken;  ///< Whose observations are used; empty before the first.

  /// "BACK, RGBD", for sentences.
  [[nodiscard]] std::string labels() const;

  /// What is to be said where there are several sensors: how much each brought, and whose was used.
  [[nodiscard]] std::optional<std::string> sentence() const;
};

}  // namespace wardslam::sources
