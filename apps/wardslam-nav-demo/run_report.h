#pragma once

#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "mission.h"
#include "simulation.h"
#include "truth.h"

namespace wardslam::nav_demo {

/// What came of a run, in a sentence.
[[nodiscard]] std::string sentenceOf(const RunRecord& run, const Mission& mission);

/// What was told, where the truth is from, a line for each run, and the whole.
void print(std::ostream& out, const std::vector<RunRecord>& runs, const Mission& mission, const Truth& truth);
[[nodiscard]] nlohmann::ordered_json toJson(const std::vector<RunRecord>& runs, const Mission& mission,
                                            const Truth& truth);

}  // namespace wardslam::nav_demo
