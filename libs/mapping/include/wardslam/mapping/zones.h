#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "wardslam/mapping/zone.h"

namespace wardslam::mapping {

/// The zones of a floor (P11). They may lie in each other: a place belongs to the smallest zone around it.
class Zones {
 public:
  Zones() = default;

  /// Throws core::InputError, naming the zone, for a name given twice or left out, fewer than 3 corners, a corner that
  /// is no number, sides that cross, or a type without what belongs to it (a slow zone's speed, an action).
  explicit Zones(std::vector<Zone> zones);

  /// A YAML file `zones: [{name: clean, polygon: [[x, y], ...], type: slow, max_speed_mps: 0.3}, ...]`, map frame, m;
  /// docs/map.md has the types. Throws core::InputError naming file, line and key.
  [[nodiscard]] static Zones fromFile(const std::filesystem::path& file);

  [[nodiscard]] const std::vector<Zone>& all() const { return zones_; }

  /// Name of the smallest zone around the place; empty where there is none. The border belongs to the zone.
  [[nodiscard]] std::string at(const Eigen::Vector2d& p_map_m) const;

 private:
  std::vector<Zone> zones_;  ///< Smallest first.
};

}  // namespace wardslam::mapping
