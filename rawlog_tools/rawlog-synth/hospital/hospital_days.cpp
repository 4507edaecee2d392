#include "hospital/hospital_days.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <set>
#include <utility>

#include "hospital/hospital_placing.h"

namespace wardslam::synth {
namespace {

using What = DayChange::What;

/// What happens in a night.
class Night {
 public:
  Night(const HospitalPlan& plan, const Placing& placing, std::uint32_t seed, int day, HospitalDay& hospital)
      : plan_(plan),
        placing_(placing),
        rng_(numbersOf(plan, seed, 60000 + static_cast<std::uint64_t>(day))),
        day_(day),
        items_(hospital.items),
        changes_(hospital.changes) {}

  void pass();

 private:
  void swapBetweenWards(ItemKind kind);
  void move(ItemKind kind, bool elsewhere);
  void takeAway(ItemKind kind);
  void bring(ItemKind kind);
  [[nodiscard]] std::vector<std::size_t> untouched(ItemKind kind, bool inWards) const;
  [[nodiscard]] std::optional<std::size_t> pick(ItemKind kind);
  [[nodiscard]] std::vector<std::size_t> roomsFor(ItemKind kind) const;
  [[nodiscard]] int uniform(std::size_t count) { return rng_.uniform(0, static_cast<int>(count)); }
  void note(What what, std::optional<Item> before, std::optional<Item> after);

  const HospitalPlan& plan_;
  const Placing& placing_;
  cv::RNG rng_;
  int day_;
  std::vector<Item>& items_;
  std::vector<DayChange>& changes_;
  std::set<int> touched_;  ///< Nothing is changed twice in a night.
  int new_ = 0;
};

void Night::note(What what, std::optional<Item> before, std::optional<Item> after) {
  touched_.insert(before ? before->identity : after->identity);
  changes_.push_back({day_, what, std::move(before), std::move(after)});
}

std::vector<std::size_t> Night::untouched(ItemKind kind, bool inWards) const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < items_.size(); ++i) {
    const Item& item = items_[i];
    const bool ward = plan_.rooms[item.room].kind == RoomKind::Ward;
    if (item.kind == kind && touched_.count(item.identity) == 0 && (ward || !inWards)) found.push_back(i);
  }
  return found;
}

std::optional<std::size_t> Night::pick(ItemKind kind) {
  const auto candidates = untouched(kind, false);
  if (candidates.empty()) return std::nullopt;
  return candidates[static_cast<std::size_t>(uniform(candidates.size()))];
}

std::vector<std::size_t> Night::roomsFor(ItemKind kind) const {
  std::vector<std::size_t> rooms;
  for (std::size_t i = 0; i < plan_.rooms.size(); ++i) {
    const RoomKind room = plan_.rooms[i].kind;
    const bool large = room == RoomKind::Ward || i == plan_.corridorA || i == plan_.corridorB;
    const bool any = large || room == RoomKind::Lobby || room == RoomKind::DayRoom || room == RoomKind::Store;
    if (kind == ItemKind::Bed ? large : any) rooms.push_back(i);
  }
  return rooms;
}

void Night::swapBetweenWards(ItemKind kind) {
  const auto candidates = untouched(kind, true);
  if (candidates.empty()) return;
  const std::size_t a = candidates[static_cast<std::size_t>(uniform(candidates.size()))];
  std::vector<std::size_t> others;
  for (const std::size_t i : candidates) {
    if (items_[i].room != items_[a].room) others.push_back(i);
  }
  if (others.empty()) return;
  const std::size_t b = others[static_cast<std::size_t>(uniform(others.size()))];
  const Item beforeA = items_[a];
  const Item beforeB = items_[b];
  std::swap(items_[a].T_world_item, items_[b].T_world_item);
  std::swap(items_[a].room, items_[b].room);
  if (!placing_.isFree(items_[a], items_) || !placing_.isFree(items_[b], items_)) {
    items_[a] = beforeA;
    items_[b] = beforeB;
    return;
  }
  note(What::Swapped, beforeA, items_[a]);
  note(What::Swapped, beforeB, items_[b]);
}

void Night::move(ItemKind kind, bool elsewhere) {
  const auto index = pick(kind);
  if (!index) return;
  Item& item = items_[*index];
  const auto rooms = roomsFor(kind);
  const std::size_t room = elsewhere ? rooms[static_cast<std::size_t>(uniform(rooms.size()))] : item.room;
  const auto T = placing_.atWall(item, room, items_, rng_);
  if (!T) return;
  const Item before = item;
  item.T_world_item = *T;
  item.room = room;
  note(What::Moved, before, item);
}

void Night::takeAway(ItemKind kind) {
  const auto index = pick(kind);
  if (!index || items_[*index].occupied) return;
  note(What::Gone, items_[*index], std::nullopt);
  items_.erase(items_.begin() + static_cast<std::ptrdiff_t>(*index));
}

void Night::bring(ItemKind kind) {
  if (new_ == kMostNewPerDay) return;
  const auto pattern = std::find_if(items_.begin(), items_.end(), [&](const Item& item) { return item.kind == kind; });
  if (pattern == items_.end()) return;
  Item item = *pattern;
  item.occupied = false;
  item.identity = item.number = firstNewIdentity(plan_.storey) + (day_ - 1) * kMostNewPerDay + new_;
  item.modelSeed = rng_.next();
  item.footprint_m = footprintOf(item);
  const auto rooms = roomsFor(kind);
  item.room = rooms[static_cast<std::size_t>(uniform(rooms.size()))];
  const auto T = placing_.atWall(item, item.room, items_, rng_);
  if (!T) return;
  item.T_world_item = *T;
  ++new_;
  note(What::New, std::nullopt, item);
  items_.push_back(item);
}

void Night::pass() {
  for (const ItemKind kind : {ItemKind::Bed, ItemKind::Wheelchair, ItemKind::Trolley, ItemKind::Chair})
    swapBetweenWards(kind);
  const std::pair<ItemKind, int> moves[] = {{ItemKind::Chair, 8},   {ItemKind::Trolley, 4}, {ItemKind::Wheelchair, 4},
                                            {ItemKind::IvStand, 3}, {ItemKind::Bed, 3},     {ItemKind::Screen, 2}};
  for (const auto& [kind, count] : moves) {
    for (int i = 0; i < count; ++i) move(kind, i % 2 == 0);
  }
  const ItemKind comeAndGo[] = {ItemKind::Chair,      ItemKind::Chair, ItemKind::Trolley,
                                ItemKind::Wheelchair, ItemKind::Bed,   ItemKind::IvStand};
  for (const ItemKind kind : comeAndGo) takeAway(kind);
  for (const ItemKind kind : comeAndGo) bring(kind);
}

}  // namespace

const char* nameOf(What what) {
  constexpr const char* kNames[] = {"moved", "swapped", "gone", "new"};
  return kNames[static_cast<std::size_t>(what)];
}

HospitalDay daysLater(const HospitalPlan& plan, std::vector<Item> day0, int days, std::uint32_t seed) {
  HospitalDay hospital{std::move(day0), {}};
  const Placing placing(plan);
  for (int day = 1; day <= days; ++day) Night(plan, placing, seed, day, hospital).pass();
  return hospital;
}

}  // namespace wardslam::synth
