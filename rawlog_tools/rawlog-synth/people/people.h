#pragma once

#include "people/actors.h"

namespace wardslam::synth {

/// Where everybody goes.
struct PeopleWays {
  Walker nurse;
  Walker porter;
  Walker visitor;
  PushingTime porterPushes = {};
};

/// Adds nurse, porter and visitor as instances `firstId` and up.
void addPeople(Scene& scene, std::uint16_t firstId, const PeopleWays& ways);

}  // namespace wardslam::synth
