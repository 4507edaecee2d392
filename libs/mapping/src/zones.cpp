#include "wardslam/mapping/zones.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "wardslam/core/errors.h"
#include "wardslam/core/options.h"

namespace wardslam::mapping {
namespace {

constexpr double kFastest_mps = 10.0;
constexpr double kMostTurned_rad = 4.0 * M_PI;

/// > 0 when a, b, c turn to the left.
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d ab = b - a;
  const Eigen::Vector2d ac = c - a;
  return ab.x() * ac.y() - ab.y() * ac.x();
}

bool cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, const Eigen::Vector2d& d) {
  return turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0;
}

bool crossesItself(const std::vector<Eigen::Vector2d>& polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if (cross(polygon[i], polygon[i + 1], polygon[j], polygon[(j + 1) % n])) return true;
    }
  }
  return false;
}

/// What is wrong with what it asks of robots; empty when nothing is.
std::string whyUnusableRule(const Zone& zone) {
  if (zone.type == ZoneType::Slow && !(zone.maxSpeed_mps > 0.0 && zone.maxSpeed_mps <= kFastest_mps))
    return "is slow, and needs a speed of more than 0 m/s (max_speed_mps), at most 10";
  if (zone.type == ZoneType::OneWay && !(std::abs(zone.direction_rad) <= kMostTurned_rad))
    return "has a direction that is no angle";
  if (zone.type == ZoneType::Action && zone.actions.areNone())
    return "asks for no action; it needs names in on_entry, inside or on_exit";
  return {};
}

/// What is wrong with the zone; empty when nothing is.
std::string whyUnusable(const Zone& zone) {
  if (zone.polygon_m.size() < 3) return "needs at least 3 corners";
  if (std::any_of(zone.polygon_m.begin(), zone.polygon_m.end(), [](const auto& p) { return !p.allFinite(); })) {
    return "has a corner that is not a number";
  }
  if (crossesItself(zone.polygon_m)) return "has sides that cross; list its corners in order around it";
  if (area_m2(zone) <= 0.0) return "has no area";
  return whyUnusableRule(zone);
}

/// Each type's own keys, which no other may have: what somebody meant by them would be left out.
void requireKeysOf(ZoneType type, const core::ConfigNode& node) {
  std::vector<std::string> keys{"name", "polygon", "type"};
  if (type == ZoneType::Slow) keys.insert(keys.end(), {"max_speed_mps"});
  if (type == ZoneType::OneWay) keys.insert(keys.end(), {"direction_deg"});
  if (type == ZoneType::Action) keys.insert(keys.end(), {"on_entry", "inside", "on_exit"});
  node.requireKeys(keys);
}

ZoneType typeOf(const core::ConfigNode& node) {
  if (!node.child("type").exists()) return ZoneType::Place;
  const auto name = node.child("type").yaml().as<std::string>("");
  const auto type = zoneTypeFrom(name);
  if (!type) node.child("type").fail("is none of place, forbidden, slow, one_way, action, release: '" + name + "'");
  return *type;
}

void parseRule(const core::ConfigNode& node, Zone& zone) {
  constexpr double kRadiansPerDegree = M_PI / 180.0;
  const auto isMissing = [&node](const char* key) { return !node.child(key).exists(); };
  const auto actions = [&node](const char* key) {
    return node.child(key).yaml().as<std::vector<std::string>>(std::vector<std::string>());
  };
  zone.type = typeOf(node);
  requireKeysOf(zone.type, node);
  if (zone.type == ZoneType::Slow) {
    if (isMissing("max_speed_mps")) node.fail("a slow zone needs max_speed_mps");
    zone.maxSpeed_mps = node.child("max_speed_mps").yaml().as<double>();
  }
  if (zone.type == ZoneType::OneWay) {
    if (isMissing("direction_deg")) node.fail("a one-way zone needs direction_deg, of the way to go (0: along x)");
    zone.direction_rad = kRadiansPerDegree * node.child("direction_deg").yaml().as<double>();
  }
  if (zone.type == ZoneType::Action) zone.actions = {actions("on_entry"), actions("inside"), actions("on_exit")};
}

Zone parseZone(const core::ConfigNode& node) {
  Zone zone;
  try {
    zone.name = node.child("name").yaml().as<std::string>("");
    parseRule(node, zone);
    const YAML::Node corners = node.child("polygon").yaml();
    for (const auto& corner : corners) {
      if (corner.size() != 2) node.fail("a corner of a polygon is a pair [x, y] in metres");
      zone.polygon_m.emplace_back(corner[0].as<double>(), corner[1].as<double>());
    }
  } catch (const YAML::Exception&) {
    node.fail("a zone has a name and a polygon [[x, y], ...] in metres; docs/map.md has what else it may have");
  }
  return zone;
}

}  // namespace

Zones::Zones(std::vector<Zone> zones) : zones_(std::move(zones)) {
  std::set<std::string> names;
  for (const Zone& zone : zones_) {
    if (zone.name.empty()) throw core::InputError("a zone has no name; every zone needs one");
    if (!names.insert(zone.name).second) throw core::InputError("zone \"" + zone.name + "\" is given twice");
    if (const auto reason = whyUnusable(zone); !reason.empty()) {
      throw core::InputError("zone \"" + zone.name + "\" " + reason);
    }
  }
  std::stable_sort(zones_.begin(), zones_.end(), [](const Zone& a, const Zone& b) { return area_m2(a) < area_m2(b); });
}

Zones Zones::fromFile(const std::filesystem::path& file) {
  const auto root = core::ConfigNode::fromFile(file);
  root.requireKeys({"zones"});
  const auto list = root.child("zones");
  if (!list.exists() || !list.yaml().IsSequence()) root.fail("needs a list \"zones\" of {name, polygon}");
  std::vector<Zone> zones;
  for (std::size_t i = 0; i < list.yaml().size(); ++i) zones.push_back(parseZone(list.item(i)));
  try {
    return Zones(std::move(zones));
  } catch (const core::InputError& error) {
    throw core::InputError(file.string() + ": " + error.what());
  }
}

std::string Zones::at(const Eigen::Vector2d& p_map_m) const {
  const auto around =
      std::find_if(zones_.begin(), zones_.end(), [&](const Zone& zone) { return contains(zone, p_map_m); });
  return around == zones_.end() ? std::string() : around->name;
}

}  // namespace wardslam::mapping
