#include "hospital/hospital_furnishing.h"

#include "hospital/hospital_identities.h"
#include "hospital/hospital_rooms.h"

namespace wardslam::synth {
namespace {

/// Wards are alike on all storeys, everything else is each one's own.
cv::RNG numbersForWards(std::uint32_t seed) { return cv::RNG((static_cast<std::uint64_t>(seed) << 32U) + 20999); }

cv::RNG numbersForRoom(const HospitalPlan& plan, std::uint32_t seed, std::size_t room) {
  return plan.rooms[room].kind == RoomKind::Ward ? numbersForWards(seed) : numbersOf(plan, seed, 20000 + room);
}

/// Tells storeys apart by their numbers.
void number(std::vector<Item>& items, int storey) {
  for (Item& item : items) {
    item.identity += kIdentitiesPerStorey * storey;
    item.number += kNumbersPerStorey * storey;
  }
}

void furnishRoom(Furnisher& f, std::size_t index, bool patients) {
  switch (f.plan().rooms[index].kind) {
    case RoomKind::Corridor:
      return furnishCorridor(f, index);
    case RoomKind::Ward:
      return furnishWard(f, index, patients);
    case RoomKind::NurseStation:
      return furnishNurseStation(f, index);
    case RoomKind::Lobby:
      return furnishLobby(f, index);
    case RoomKind::DayRoom:
      return furnishDayRoom(f, index);
    case RoomKind::Store:
      return furnishStore(f, index);
    case RoomKind::Toilet:
      return furnishToilet(f, index);
    case RoomKind::Bath:
      return furnishBath(f, index);
    case RoomKind::Office:
      return furnishOffice(f, index);
    case RoomKind::Treatment:
      return furnishTreatment(f, index, patients);
    case RoomKind::Utility:
      return furnishUtility(f, index);
  }
}

}  // namespace

std::vector<Item> furnish(const HospitalPlan& plan, std::uint32_t seed, bool patients) {
  Furnisher furnisher(plan, numbersForWards(seed));
  for (std::size_t i = 0; i < plan.doors.size(); ++i) {
    furnisher.useNumbers(numbersOf(plan, seed, 21000 + i));
    addDoor(furnisher, plan.doors[i]);
  }
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) {
    furnisher.useNumbers(numbersForRoom(plan, seed, i));
    furnishRoom(furnisher, i, patients);
    if (plan.rooms[i].kind != RoomKind::Corridor) addWindow(furnisher, i);
  }
  std::vector<Item> items = furnisher.take();
  number(items, plan.storey);
  return items;
}

std::vector<std::string> signTexts(const HospitalPlan& plan) {
  std::vector<std::string> texts;
  for (const Room& room : plan.rooms) texts.push_back(room.name);
  texts.emplace_back("EXIT");
  texts.emplace_back("WARDS");
  return texts;
}

}  // namespace wardslam::synth
