#include "wardslam/query/map_query.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

#include "floor_ways.h"
#include "wardslam/query/drivable_floor.h"

namespace wardslam::query {
namespace {

Eigen::AlignedBox2d footprint(const mapping::MapObject& object) {
  return {object.box_m.min().head<2>(), object.box_m.max().head<2>()};
}

/// Where somebody would sit, or something would be put down; see ObjectFilter::onlyFree.
Eigen::AlignedBox3d seatOf(const mapping::MapObject& object) {
  constexpr double kSeatHeight = 0.4;  // share of the whole height
  const Eigen::Vector3d quarter = object.box_m.sizes() / 4;
  Eigen::AlignedBox3d seat(object.box_m.min() + quarter, object.box_m.max() - quarter);
  seat.min().z() = object.box_m.min().z() + kSeatHeight * object.box_m.sizes().z();
  seat.max().z() = object.box_m.max().z();
  return seat;
}

/// Boxes that only touch do not overlap.
bool overlap(const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b) {
  return (a.min().array() < b.max().array()).all() && (b.min().array() < a.max().array()).all();
}

struct Entry {
  const mapping::MapObject* object = nullptr;
  std::vector<bool> inZone;  ///< By the zone's place in Index::zones.
  bool isFree = true;
};

/// From which cells objects are in reach: a list for every cell, one after another in one array.
class Arrivals {
 public:
  Arrivals() = default;
  Arrivals(std::size_t cellCount, const std::vector<std::pair<FloorWays::Cell, std::uint32_t>>& pairs)
      : begin_(cellCount + 1), entries_(pairs.size()) {
    for (const auto& [cell, entry] : pairs) ++begin_[cell + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    auto next = begin_;
    for (const auto& [cell, entry] : pairs) entries_[next[cell]++] = entry;
  }

  /// The first entry in reach of a cell that `wanted` says yes to.
  [[nodiscard]] std::optional<std::uint32_t> find(FloorWays::Cell cell, const std::vector<bool>& wanted) const {
    for (std::size_t i = begin_[cell]; i < begin_[cell + 1]; ++i) {
      if (wanted[entries_[i]]) return entries_[i];
    }
    return std::nullopt;
  }

 private:
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> entries_;
};

}  // namespace

struct MapQuery::Index {
  explicit Index(const mapping::SemanticMap& map);

  void findZones(const mapping::SemanticMap& map);
  void findFree();
  void findWaysTo();

  [[nodiscard]] std::size_t zoneNamed(const std::string& name) const {
    const auto zone = std::find_if(zones.begin(), zones.end(), [&](const auto& z) { return z.name == name; });
    return static_cast<std::size_t>(zone - zones.begin());
  }

  /// Calls `take` with the number of every entry that passes.
  template <class Take>
  void select(const ObjectFilter& filter, const Take& take) const;

  const mapping::FloorPlan& floorPlan;
  double newestStamp_s = 0.0;
  std::vector<mapping::Zone> zones;  ///< Smallest first.
  std::vector<Entry> entries;        ///< In order of ids.
  FloorWays ways;
  Arrivals arrivals;
};

MapQuery::Index::Index(const mapping::SemanticMap& map)
    : floorPlan(map.floorPlan),
      ways(closeZones(map.floorPlan, mapping::zonesOfType(map.zones, mapping::ZoneType::Forbidden))) {
  for (const auto& [id, keyframe] : map.keyframes) newestStamp_s = std::max(newestStamp_s, keyframe.stamp_s);
  findZones(map);
  findFree();
  findWaysTo();
}

void MapQuery::Index::findZones(const mapping::SemanticMap& map) {
  zones = map.zones;
  std::stable_sort(zones.begin(), zones.end(),
                   [](const auto& a, const auto& b) { return mapping::area_m2(a) < mapping::area_m2(b); });
  for (const auto& [id, object] : map.objects) {
    Entry entry{&object, std::vector<bool>(zones.size()), true};
    for (std::size_t i = 0; i < zones.size(); ++i)
      entry.inZone[i] = mapping::contains(zones[i], object.centroid_m.head<2>());
    entries.push_back(std::move(entry));
  }
}

/// A sweep along x: only objects that begin not too far to the left can reach into a seat.
void MapQuery::Index::findFree() {
  std::vector<const mapping::MapObject*> byMinX;
  double widest_m = 0.0;
  for (const auto& entry : entries) {
    if (entry.object->state == mapping::ObjectState::Gone) continue;
    byMinX.push_back(entry.object);
    widest_m = std::max(widest_m, entry.object->box_m.sizes().x());
  }
  const auto minX = [](const mapping::MapObject* object) { return object->box_m.min().x(); };
  std::sort(byMinX.begin(), byMinX.end(), [&](const auto* a, const auto* b) { return minX(a) < minX(b); });
  for (auto& entry : entries) {
    const auto seat = seatOf(*entry.object);
    auto other = std::lower_bound(byMinX.begin(), byMinX.end(), seat.min().x() - widest_m,
                                  [&](const auto* object, double x) { return minX(object) < x; });
    for (; other != byMinX.end() && minX(*other) < seat.max().x(); ++other) {
      if (*other != entry.object && overlap(seat, (*other)->box_m)) entry.isFree = false;
    }
  }
}

void MapQuery::Index::findWaysTo() {
  std::vector<std::pair<FloorWays::Cell, std::uint32_t>> inReach;
  for (std::uint32_t i = 0; i < entries.size(); ++i) {
    ways.forEachFreeCellNear(footprint(*entries[i].object), kReach_m,
                             [&](FloorWays::Cell cell) { inReach.emplace_back(cell, i); });
  }
  arrivals = Arrivals(ways.cellCount(), inReach);
}

template <class Take>
void MapQuery::Index::select(const ObjectFilter& filter, const Take& take) const {
  const std::size_t zone = filter.zone ? zoneNamed(*filter.zone) : 0;
  if (filter.zone && zone == zones.size()) return;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const mapping::MapObject& object = *entries[i].object;
    if (filter.classId && object.classId != *filter.classId) continue;
    if (filter.zone && !entries[i].inZone[zone]) continue;
    if (filter.onlyFree && !entries[i].isFree) continue;
    if (filter.states.count(object.state) == 0) continue;
    if (filter.box_m && !filter.box_m->intersects(object.box_m)) continue;
    const double unseen_s = newestStamp_s - object.lastSeen_s;
    if (filter.unseenAtLeast_s && unseen_s < *filter.unseenAtLeast_s) continue;
    if (filter.unseenAtMost_s && unseen_s > *filter.unseenAtMost_s) continue;
    take(i);
  }
}

MapQuery::MapQuery(const mapping::SemanticMap& map) : index_(std::make_unique<Index>(map)) {}
MapQuery::~MapQuery() = default;
MapQuery::MapQuery(MapQuery&&) noexcept = default;
MapQuery& MapQuery::operator=(MapQuery&&) noexcept = default;

std::vector<const mapping::MapObject*> MapQuery::objects(const ObjectFilter& filter) const {
  std::vector<const mapping::MapObject*> found;
  index_->select(filter, [&](std::size_t i) { found.push_back(index_->entries[i].object); });
  return found;
}

std::optional<NearObject> MapQuery::nearest(const Eigen::Vector3d& p_map_m, const ObjectFilter& filter) const {
  NearObject best{nullptr, std::numeric_limits<double>::infinity()};
  index_->select(filter, [&](std::size_t i) {
    const mapping::MapObject* object = index_->entries[i].object;
    const double distance_m = (object->centroid_m - p_map_m).norm();
    if (distance_m < best.distance_m) best = {object, distance_m};
  });
  return best.object != nullptr ? std::optional(best) : std::nullopt;
}

std::optional<NearObject> MapQuery::nearest(const Eigen::Vector2d& p_map_m, const ObjectFilter& filter) const {
  NearObject best{nullptr, std::numeric_limits<double>::infinity()};
  index_->select(filter, [&](std::size_t i) {
    const mapping::MapObject* object = index_->entries[i].object;
    const double distance_m = (object->centroid_m.head<2>() - p_map_m).norm();
    if (distance_m < best.distance_m) best = {object, distance_m};
  });
  return best.object != nullptr ? std::optional(best) : std::nullopt;
}

std::optional<NearObject> MapQuery::nearestAlongFloor(const Eigen::Vector2d& p_map_m,
                                                      const ObjectFilter& filter) const {
  const auto start = index_->ways.freeCellNear(p_map_m, kReach_m);
  std::vector<bool> wanted(index_->entries.size());
  bool any = false;
  index_->select(filter, [&](std::size_t i) { any = wanted[i] = true; });
  if (!start || !any) return std::nullopt;

  std::optional<std::uint32_t> reached;
  const auto distance_m = index_->ways.walk(*start, [&](FloorWays::Cell cell) {
    reached = index_->arrivals.find(cell, wanted);
    return reached.has_value();
  });
  if (!distance_m) return std::nullopt;
  return NearObject{index_->entries[*reached].object, *distance_m};
}

Place MapQuery::at(const Eigen::Vector3d& p_map_m) const {
  Place place;
  for (const auto& entry : index_->entries) {
    const bool stands = entry.object->state != mapping::ObjectState::Gone;
    if (stands && entry.object->box_m.contains(p_map_m)) place.objects.push_back(entry.object);
  }
  std::stable_sort(place.objects.begin(), place.objects.end(),
                   [](const auto* a, const auto* b) { return a->box_m.volume() < b->box_m.volume(); });
  for (const auto& zone : index_->zones) {
    if (mapping::contains(zone, p_map_m.head<2>())) place.zones.push_back(zone.name);
  }
  const mapping::FloorPlan& plan = index_->floorPlan;
  const Eigen::Vector2d cell = ((p_map_m.head<2>() - plan.origin_m) / plan.resolution_m).array().floor();
  if (cell.x() >= 0 && cell.y() >= 0 && cell.x() < plan.cells.cols && cell.y() < plan.cells.rows) {
    place.floor = plan.cells.at<unsigned char>(static_cast<int>(cell.y()), static_cast<int>(cell.x()));
  }
  return place;
}

}  // namespace wardslam::query
