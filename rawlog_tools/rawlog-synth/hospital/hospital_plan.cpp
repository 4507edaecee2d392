#include "hospital/hospital_plan.h"

#include <algorithm>
#include <array>
#include <opencv2/core.hpp>

namespace wardslam::synth {
namespace {

using Eigen::Vector2d;

constexpr double kDoor_m = 1.35;        ///< A bed fits through.
constexpr double kNarrowDoor_m = 0.95;  ///< Of rooms where no bed is brought.
constexpr double kStoreDoor_m = 1.8;    ///< What of the store's wall is left to its door.
constexpr double kWidePassage_m = 3.2;

/// A room of a strip before it has its place.
struct Slot {
  RoomKind kind;
  std::string name;
  double width_m;
};

struct Measures {
  double length_m;
  double ward_m;
  double south_m;  ///< Depths of the strips of rooms, and
  double core_m;
  double north_m;
  double corridor_m;  ///< the width of the corridors between them.
};

class Planner {
 public:
  explicit Planner(std::uint32_t seed) : rng_((static_cast<std::uint64_t>(seed) << 8U) + 11) {}
  /// Of a storey above the ground floor, which is planned already.
  Planner(const Planner& ground, std::uint32_t seed, int storey)
      : rng_((static_cast<std::uint64_t>(storey) << 40U) + (static_cast<std::uint64_t>(seed) << 8U) + 11),
        storey_(storey),
        m_(ground.m_),
        middle_m_(ground.middle_m_) {}

  [[nodiscard]] HospitalPlan plan();

 private:
  void takeMeasures();
  void addCorridors();
  void addSouth();
  void addNorth();
  void addCore();
  void addHalf(const std::vector<Slot>& slots, double from_m, double to_m);
  void addStrip(const std::vector<Slot>& slots, double fromX_m, double y0_m, double y1_m, bool doorToNorth);
  void addDoor(std::size_t room, std::size_t corridor, double middleX_m, double y_m, double width_m, DoorState state);
  void addDoorOf(std::size_t room, bool toNorth);
  void addPassages();
  [[nodiscard]] std::size_t addRoom(RoomKind kind, const std::string& name, const Eigen::AlignedBox2d& area_m,
                                    bool doorToNorth);
  [[nodiscard]] bool bareIsPossible() const;
  void numberTheWards();
  void setStates();
  template <typename T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t i = items.size(); i > 1; --i)
      std::swap(items[i - 1], items[static_cast<std::size_t>(rng_.uniform(0, static_cast<int>(i)))]);
  }

  [[nodiscard]] double yA_m() const { return m_.south_m + m_.corridor_m / 2; }
  [[nodiscard]] double coreFrom_m() const { return m_.south_m + m_.corridor_m; }
  [[nodiscard]] double coreTo_m() const { return coreFrom_m() + m_.core_m; }
  [[nodiscard]] double northFrom_m() const { return coreTo_m() + m_.corridor_m; }

  cv::RNG rng_;
  int storey_ = 0;
  Measures m_{};
  double middle_m_ = 0.0;  ///< Where the middle crossing begins.
  HospitalPlan plan_;
};

void Planner::takeMeasures() {
  m_.length_m = rng_.uniform(61.0, 64.0);
  m_.ward_m = rng_.uniform(8.2, 8.8);
  m_.south_m = m_.north_m = rng_.uniform(6.4, 6.9);  // wards on both sides look the same
  m_.core_m = rng_.uniform(4.8, 5.6);
  m_.corridor_m = rng_.uniform(3.45, 3.7);
  middle_m_ = m_.length_m / 2 + rng_.uniform(-3.5, 1.5);
}

std::size_t Planner::addRoom(RoomKind kind, const std::string& name, const Eigen::AlignedBox2d& area_m,
                             bool doorToNorth) {
  Room room;
  room.kind = kind;
  room.name = name;
  room.area_m = area_m;
  const auto x = static_cast<float>(area_m.center().x());
  const auto y = static_cast<float>(doorToNorth ? area_m.max().y() : area_m.min().y());
  room.T_world_room.translation() << x, y, 0.0F;
  if (doorToNorth) room.T_world_room.linear() = Eigen::Vector3f(-1, -1, 1).asDiagonal();
  plan_.rooms.push_back(room);
  return plan_.rooms.size() - 1;
}

void Planner::addCorridors() {
  const auto corridor = [&](const std::string& name, const Vector2d& from_m, const Vector2d& to_m) {
    return addRoom(RoomKind::Corridor, name, {from_m, to_m}, false);
  };
  plan_.corridorA = corridor("CORRIDOR A", {0, m_.south_m}, {m_.length_m, coreFrom_m()});
  plan_.corridorB = corridor("CORRIDOR B", {0, coreTo_m()}, {m_.length_m, northFrom_m()});
  const std::array<double, 3> begins_m = {0.0, middle_m_, m_.length_m - m_.corridor_m};
  for (std::size_t i = 0; i < 3; ++i)
    plan_.crossings[i] = corridor("CROSSING " + std::to_string(i + 1), {begins_m[i], coreFrom_m()},
                                  {begins_m[i] + m_.corridor_m, coreTo_m()});
}

void Planner::addDoor(std::size_t room, std::size_t corridor, double middleX_m, double y_m, double width_m,
                      DoorState state) {
  Door door;
  door.room = room;
  door.corridor = corridor;
  door.from_m = {middleX_m - width_m / 2, y_m};
  door.to_m = {middleX_m + width_m / 2, y_m};
  // Seen from within the room, the leaf always hangs on the same side.
  if (plan_.rooms[room].T_world_room.linear()(0, 0) < 0) std::swap(door.from_m, door.to_m);
  door.state = state;
  plan_.doors.push_back(door);
}

void Planner::addDoorOf(std::size_t index, bool toNorth) {
  const Room& room = plan_.rooms[index];
  const double y = toNorth ? room.area_m.max().y() : room.area_m.min().y();
  const double x = room.area_m.center().x();
  const std::size_t corridor =
      std::abs(y - m_.south_m) < 0.1 || std::abs(y - coreFrom_m()) < 0.1 ? plan_.corridorA : plan_.corridorB;
  switch (room.kind) {
    case RoomKind::Lobby:
    case RoomKind::DayRoom:
    case RoomKind::NurseStation:
      addDoor(index, corridor, x, y, kWidePassage_m, DoorState::Passage);
      break;
    case RoomKind::Store: {  // at one end, so that the rest of its wall stays bare
      const double side = rng_.uniform(0, 2) == 0 ? -1.0 : 1.0;
      const double doorX = x + side * (room.area_m.sizes().x() - kStoreDoor_m) / 2;
      addDoor(index, corridor, doorX, y, kDoor_m, DoorState::Closed);
      plan_.bare = {corridor, side < 0 ? room.area_m.max().x() - kBareLength_m : room.area_m.min().x(), 0.0};
      plan_.bare.toX_m = plan_.bare.fromX_m + kBareLength_m;
      break;
    }
    case RoomKind::Toilet:
    case RoomKind::Office:
      addDoor(index, corridor, x, y, kNarrowDoor_m, DoorState::Closed);
      break;
    default:
      addDoor(index, corridor, x, y, kDoor_m, DoorState::Open);
  }
}

void Planner::addStrip(const std::vector<Slot>& slots, double fromX_m, double y0_m, double y1_m, bool doorToNorth) {
  for (const Slot& slot : slots) {
    const Eigen::AlignedBox2d area(Vector2d(fromX_m, y0_m), Vector2d(fromX_m + slot.width_m, y1_m));
    addDoorOf(addRoom(slot.kind, slot.name, area, doorToNorth), doorToNorth);
    fromX_m += slot.width_m;
  }
}

double widthOf(const std::vector<Slot>& slots) {
  double sum_m = 0.0;
  for (const Slot& slot : slots) sum_m += slot.width_m;
  return sum_m;
}

void Planner::addSouth() {
  std::vector<Slot> slots(4, {RoomKind::Ward, "WARD", m_.ward_m});
  slots.push_back({RoomKind::Store, "STORE", kBareLength_m + kStoreDoor_m});
  slots.push_back({RoomKind::Bath, "BATH", rng_.uniform(4.5, 6.0)});
  shuffle(slots);
  const Slot lobby{RoomKind::Lobby, "LOBBY", m_.length_m - widthOf(slots)};
  slots.insert(rng_.uniform(0, 2) == 0 ? slots.begin() : slots.end(), lobby);
  addStrip(slots, 0.0, 0.0, m_.south_m, true);
}

void Planner::addNorth() {
  std::vector<Slot> slots(4, {RoomKind::Ward, "WARD", m_.ward_m});
  slots.push_back({RoomKind::Treatment, "TREATMENT", rng_.uniform(4.8, 5.8)});
  slots.push_back({RoomKind::Office, "DOCTORS", rng_.uniform(3.6, 4.6)});
  slots.push_back({RoomKind::Utility, "SLUICE", rng_.uniform(3.4, 4.4)});
  shuffle(slots);
  const Slot dayRoom{RoomKind::DayRoom, "DAY ROOM", m_.length_m - widthOf(slots)};
  slots.insert(slots.begin() + rng_.uniform(0, static_cast<int>(slots.size()) + 1), dayRoom);
  addStrip(slots, 0.0, northFrom_m(), northFrom_m() + m_.north_m, false);
}

/// Rooms of the core between two crossings: all but the nurse station have their doors to corridor B.
void Planner::addHalf(const std::vector<Slot>& slots, double from_m, double to_m) {
  double flexible_m = to_m - from_m - widthOf(slots);
  std::size_t flexible = 0;
  for (const Slot& slot : slots) flexible += slot.kind == RoomKind::Utility ? 1 : 0;
  for (Slot slot : slots) {
    if (slot.kind == RoomKind::Utility) slot.width_m += flexible_m / static_cast<double>(flexible);
    addStrip({slot}, from_m, coreFrom_m(), coreTo_m(), slot.kind != RoomKind::NurseStation);
    from_m += slot.width_m;
  }
}

void Planner::addCore() {
  std::vector<Slot> withNurses = {{RoomKind::NurseStation, "NURSE STATION", rng_.uniform(8.5, 10.0)},
                                  {RoomKind::Toilet, "WC WOMEN", 3.0},
                                  {RoomKind::Toilet, "WC MEN", 3.0},
                                  {RoomKind::Utility, "MEDICINE", 3.0},
                                  {RoomKind::Utility, "STAFF", 3.0}};
  std::vector<Slot> others = {{RoomKind::Utility, "LINEN", 3.0},
                              {RoomKind::Toilet, "WC STAFF", 3.0},
                              {RoomKind::Utility, "KITCHEN", 3.5},
                              {RoomKind::Office, "OFFICE", rng_.uniform(4.0, 5.0)},
                              {RoomKind::Utility, "MEETING", 4.0}};
  shuffle(withNurses);
  shuffle(others);
  const double west_m = m_.corridor_m;
  const double east_m = m_.length_m - m_.corridor_m;
  const double secondHalf_m = middle_m_ + m_.corridor_m;
  const bool bareIsWest = plan_.bare.toX_m < middle_m_;
  addHalf(bareIsWest ? others : withNurses, west_m, middle_m_);
  addHalf(bareIsWest ? withNurses : others, secondHalf_m, east_m);
}

void Planner::addPassages() {
  for (const std::size_t crossing : plan_.crossings) {
    const Eigen::AlignedBox2d area = plan_.rooms[crossing].area_m;
    for (const auto& [corridor, y] : {std::pair(plan_.corridorA, area.min().y()), {plan_.corridorB, area.max().y()}}) {
      addDoor(crossing, corridor, area.center().x(), y, area.sizes().x() - kInnerWall_m, DoorState::Passage);
      plan_.doors.back().height_m = plan_.height_m;
    }
  }
}

bool Planner::bareIsPossible() const {
  const WallStretch& bare = plan_.bare;
  const bool west = bare.fromX_m > m_.corridor_m && bare.toX_m < middle_m_;
  const bool east = bare.fromX_m > middle_m_ + m_.corridor_m && bare.toX_m < m_.length_m - m_.corridor_m;
  return west || east;
}

void Planner::numberTheWards() {
  int ward = 10 * storey_;
  for (Room& room : plan_.rooms) {
    if (room.kind == RoomKind::Ward) room.name += " " + std::to_string(++ward);
    room.id = room.name;
    std::transform(room.id.begin(), room.id.end(), room.id.begin(),
                   [](char c) { return c == ' ' ? '-' : static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
    if (storey_ > 0) room.id = "s" + std::to_string(storey_) + "-" + room.id;
  }
}

/// Two wards are shut off; of the smaller rooms some are open, some ajar, some closed.
void Planner::setStates() {
  std::vector<std::size_t> wards;
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < plan_.doors.size(); ++i) {
    const Door& door = plan_.doors[i];
    if (door.state == DoorState::Passage) continue;
    (plan_.rooms[door.room].kind == RoomKind::Ward ? wards : others).push_back(i);
  }
  shuffle(wards);
  shuffle(others);
  for (std::size_t i = 0; i < wards.size(); ++i)
    plan_.doors[wards[i]].state = i == 0 ? DoorState::Closed : i == 1 ? DoorState::Ajar : DoorState::Open;
  for (std::size_t i = 0; i < others.size(); ++i)
    plan_.doors[others[i]].state = i % 3 == 0 ? DoorState::Ajar : i % 3 == 1 ? DoorState::Closed : DoorState::Open;
  for (Door& door : plan_.doors) {
    if (door.state == DoorState::Open) door.opening_rad = rng_.uniform(1.5F, 1.62F);
    if (door.state == DoorState::Ajar) door.opening_rad = rng_.uniform(0.25F, 0.7F);
  }
}

HospitalPlan Planner::plan() {
  do {
    plan_ = HospitalPlan();
    plan_.storey = storey_;
    if (storey_ == 0) takeMeasures();
    plan_.size_m = {m_.length_m, northFrom_m() + m_.north_m};
    addCorridors();
    addSouth();
  } while (!bareIsPossible());  // its other side must be rooms, too
  addNorth();
  addCore();
  addPassages();
  numberTheWards();
  setStates();
  return plan_;
}

}  // namespace

const char* nameOf(RoomKind kind) {
  constexpr const char* kNames[] = {"corridor", "ward", "nurse_station", "lobby",     "day_room", "store",
                                    "toilet",   "bath", "office",        "treatment", "utility"};
  return kNames[static_cast<std::size_t>(kind)];
}

const char* nameOf(DoorState state) {
  constexpr const char* kNames[] = {"open", "ajar", "closed", "passage"};
  return kNames[static_cast<std::size_t>(state)];
}

double HospitalPlan::area_m2() const {
  double sum_m2 = 0.0;
  for (const Room& room : rooms) sum_m2 += room.area_m.volume();
  return sum_m2;
}

std::size_t HospitalPlan::roomAt(const Vector2d& p_m) const {
  const auto room = std::find_if(rooms.begin(), rooms.end(), [&](const Room& r) { return r.area_m.contains(p_m); });
  return static_cast<std::size_t>(room - rooms.begin());
}

HospitalPlan planHospital(std::uint32_t seed, int storey) {
  Planner ground(seed);
  HospitalPlan plan = ground.plan();
  return storey == 0 ? plan : Planner(ground, seed, storey).plan();
}

cv::RNG numbersOf(const HospitalPlan& plan, std::uint32_t seed, std::uint64_t what) {
  constexpr std::uint64_t kApart = 1000000;
  return cv::RNG((static_cast<std::uint64_t>(seed) << 32U) + kApart * static_cast<std::uint64_t>(plan.storey) + what);
}

}  // namespace wardslam::synth
