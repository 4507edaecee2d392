#pragma once

#include "hospital/hospital_furnisher.h"

/// How each kind of room is furnished.
namespace wardslam::synth {

/// Four beds in two rows and what belongs to them.
void furnishWard(Furnisher& furnisher, std::size_t room, bool patients);
void furnishLobby(Furnisher& furnisher, std::size_t room);
void furnishDayRoom(Furnisher& furnisher, std::size_t room);
void furnishNurseStation(Furnisher& furnisher, std::size_t room);
void furnishStore(Furnisher& furnisher, std::size_t room);
void furnishToilet(Furnisher& furnisher, std::size_t room);
void furnishBath(Furnisher& furnisher, std::size_t room);
void furnishOffice(Furnisher& furnisher, std::size_t room);
void furnishTreatment(Furnisher& furnisher, std::size_t room, bool patients);
void furnishUtility(Furnisher& furnisher, std::size_t room);
void furnishCorridor(Furnisher& furnisher, std::size_t room);

/// A poster of those that may hang anywhere.
[[nodiscard]] int anyPoster(Furnisher& furnisher);
/// A window in the wall across from the door, where there is an outer one.
void addWindow(Furnisher& furnisher, std::size_t room);
/// Its leaf and the sign beside it.
void addDoor(Furnisher& furnisher, const Door& door);

}  // namespace wardslam::synth
