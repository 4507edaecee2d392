#pragma once

#include "map_questions.h"

namespace wardslam::apps {

/// Prints the rooms of the floor plan and the doors between them on standard output, and draws them where that is
/// wanted.
void answerRooms(const MapQuestion& question, const mapping::SemanticMap& map);
void addRoomsOptions(CLI::App& verb, MapQuestion& question);

}  // namespace wardslam::apps
