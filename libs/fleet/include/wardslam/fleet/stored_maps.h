#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "wardslam/mapping/semantic_map.h"

namespace wardslam::fleet {

/// Whose map of which storey. What is empty does not matter.
struct MapChoice {
  std::string site;
  std::string storey;
  std::string robot;
  std::string name;
};

/// A map in the database, at a glance.
struct StoredMap {
  std::int64_t id = 0;
  std::string site;
  std::string storey;
  std::string robot;
  std::string name;
  double lastStamp_s = 0.0;
  std::uint64_t size_bytes = 0;  ///< Of its file.
};

/// Those chosen, the one with the newest keyframe first. Throws core::InputError.
[[nodiscard]] std::vector<StoredMap> storedMaps(const std::string& url, const MapChoice& choice);

/// The newest of those chosen as it was pushed, but without its cloud, free fans and grounds: what is asked for things,
/// zones and floor. Throws core::InputError, also where there is none.
[[nodiscard]] mapping::SemanticMap readNewestMap(const std::string& url, const MapChoice& choice);

/// Writes the file of the newest of those chosen as it was pushed, byte for byte, when all of it has come. Throws
/// core::InputError, also where there is none.
StoredMap pullNewestMap(const std::string& url, const MapChoice& choice, const std::filesystem::path& file);

}  // namespace wardslam::fleet
