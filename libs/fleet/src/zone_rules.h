#pragma once

#include <nlohmann/json.hpp>

#include "wardslam/mapping/zone.h"

namespace wardslam::fleet {

/// What a zone asks of robots, as the database keeps it.
[[nodiscard]] nlohmann::json ruleOf(const mapping::Zone& zone);

/// The way back, into a zone.
void takeRule(const nlohmann::json& rule, mapping::Zone& zone);

}  // namespace wardslam::fleet
