#pragma once

#include <cstdint>
#include <vector>

#include "hospital/hospital_items.h"
#include "hospital/hospital_plan.h"

namespace wardslam::synth {

/// Everything that stands and hangs in the storey on day 0, by identity: 1, 2, 3 …, above the ground floor from
/// another number on. Wards are furnished alike, in their own frames. `patients`: somebody lies in some of the beds.
[[nodiscard]] std::vector<Item> furnish(const HospitalPlan& plan, std::uint32_t seed, bool patients);

/// What the cells of the texture of signs say: the rooms' names by their index, then kExitSign and kWardsSign.
[[nodiscard]] std::vector<std::string> signTexts(const HospitalPlan& plan);

}  // namespace wardslam::synth
