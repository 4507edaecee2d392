#pragma once

#include "hospital/hospital_days.h"
#include "hospital/hospital_route.h"

namespace wardslam::synth {

/// Which hospital is rendered beyond its seed: when, and who drives where.
struct HospitalOptions {
  int day = 0;  ///< 0 to kLastDay.
  RouteChoice route;
};

}  // namespace wardslam::synth
