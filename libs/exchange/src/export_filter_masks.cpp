#include <algorithm>
#include <cmath>
#include <sstream>

#include "ros_map_files.h"
#include "wardslam/core/atomic_file.h"
#include "wardslam/exchange/fleet_export.h"

namespace wardslam::exchange {
namespace {

using mapping::FloorPlan;
using mapping::Zone;
using mapping::ZoneType;

constexpr double kMostOfMask = 100.0;  // as occupancy grids of ROS have it

/// Pixels are the values themselves: in `raw` mode no threshold stands between. The thresholds must be there.
constexpr const char* kRaw = "mode: raw\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";

/// A value for each cell, by the zones that its centre lies in.
template <class ValueIn>
void writeMask(const FloorPlan& plan, const std::vector<Zone>& zones, const ValueIn& valueIn,
               const std::filesystem::path& file) {
  writeRosMap(
      plan,
      [&](int row, int column) {
        const Eigen::Vector2d centre_m = plan.origin_m + plan.resolution_m * Eigen::Vector2d(column + 0.5, row + 0.5);
        unsigned char value = 0;
        for (const Zone& zone : zones) {
          if (mapping::contains(zone, centre_m)) value = valueIn(value, zone);
        }
        return value;
      },
      kRaw, file);
}

double fastestOf_mps(const std::vector<Zone>& slow) {
  double fastest_mps = 0.0;
  for (const Zone& zone : slow) fastest_mps = std::max(fastest_mps, zone.maxSpeed_mps);
  return fastest_mps > 0.0 ? fastest_mps : kMostOfMask;
}

/// Parameters of nav2_map_server's costmap_filter_info_server.
std::string filterInfo(double multiplier_mps) {
  std::ostringstream yaml;
  yaml << "costmap_filter_info_server:\n  ros__parameters:\n    type: 2\n    filter_info_topic: /speed_filter_info\n"
       << "    mask_topic: /speed_filter_mask\n    base: 0.0\n    multiplier: " << std::showpoint << multiplier_mps
       << "\n";
  return yaml.str();
}

}  // namespace

void exportKeepoutMask(const mapping::SemanticMap& map, const std::filesystem::path& file) {
  const auto set = [](unsigned char /*before*/, const Zone& /*zone*/) {
    return static_cast<unsigned char>(kMostOfMask);
  };
  writeMask(floorPlanFor(map, file), mapping::zonesOfType(map.zones, ZoneType::Forbidden), set, file);
}

void exportSpeedMask(const mapping::SemanticMap& map, const std::filesystem::path& file) {
  const auto slow = mapping::zonesOfType(map.zones, ZoneType::Slow);
  const double multiplier_mps = fastestOf_mps(slow) / kMostOfMask;
  const auto slowest = [multiplier_mps](unsigned char before, const Zone& zone) {
    const auto value = static_cast<unsigned char>(std::max(1.0, std::floor(zone.maxSpeed_mps / multiplier_mps + 1e-9)));
    return before == 0 ? value : std::min(before, value);
  };
  writeMask(floorPlanFor(map, file), slow, slowest, file);
  std::filesystem::path info = file;
  core::writeFileAtomically(info.replace_extension(".filter_info.yaml"), filterInfo(multiplier_mps));
}

}  // namespace wardslam::exchange
