#pragma once

#include "hospital/hospital_days.h"
#include "hospital/hospital_route.h"
#include "life/life.h"

namespace wardslam::synth {

/// Which hospital is rendered beyond its seed: when, and who drives where.
struct HospitalOptions {
  int day = 0;  ///< 0 to kLastDay.
  RouteChoice route;
  Density people = Density::Normal;  ///< Nobody at all where SceneOptions::people says so.
  int storeys = 1;                   ///< 1 to kMostStoreys.
  int storey = 0;                    ///< Which one is driven on, from below.
};

}  // namespace wardslam::synth
