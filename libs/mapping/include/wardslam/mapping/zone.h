#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace wardslam::mapping {

/// What a zone asks of a robot.
enum class ZoneType : std::uint8_t {
  Place,      ///< Nothing: a part of the floor with a name.
  Forbidden,  ///< To stay out.
  Slow,       ///< To go no faster than its limit.
  OneWay,     ///< To go in its direction, and never against it.
  Action,     ///< To do something on the way in, inside, or on the way out.
  Release,    ///< To ask the fleet's control before going in.
};

/// As in files: `place`, `forbidden`, `slow`, `one_way`, `action`, `release`.
[[nodiscard]] std::string toString(ZoneType type);

/// The way back; nothing for what is none.
[[nodiscard]] std::optional<ZoneType> zoneTypeFrom(const std::string& name);

/// Names of what robots do, as those who make them call it.
struct ZoneActions {
  std::vector<std::string> entry;
  std::vector<std::string> inside;
  std::vector<std::string> exit;

  [[nodiscard]] bool areNone() const { return entry.empty() && inside.empty() && exit.empty(); }
};

/// A named part of the floor (P11): a simple polygon in the map frame's x-y plane.
struct Zone {
  std::string name;
  std::vector<Eigen::Vector2d> polygon_m;  ///< At least 3 corners, not closed.
  ZoneType type = ZoneType::Place;
  double maxSpeed_mps = 0.0;  ///< Of a slow zone.
  double direction_rad =
      0.0;                   ///< Of a one-way zone: the way to go, map frame, 0 = along x, to the left of it positive.
  ZoneActions actions = {};  ///< Of an action zone.
};

/// Those of one type, in their order.
[[nodiscard]] std::vector<Zone> zonesOfType(const std::vector<Zone>& zones, ZoneType type);

/// Whether the place lies in the zone; its border belongs to it.
[[nodiscard]] bool contains(const Zone& zone, const Eigen::Vector2d& p_map_m);

/// How far the place is from the zone; 0 within it.
[[nodiscard]] double distance_m(const Zone& zone, const Eigen::Vector2d& p_map_m);

[[nodiscard]] double area_m2(const Zone& zone);

}  // namespace wardslam::mapping
