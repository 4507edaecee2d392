#pragma once

#include <nlohmann/json.hpp>

#include "plan_view.h"
#include "run_record.h"
#include "wardslam/evaluation/absolute_trajectory_error.h"

namespace wardslam::report {

/// What share/report/report.js draws: `plots` (title, unit, names of lines, rows that begin with the time), `lost`
/// (from, to) and `way` (time, x, y in the drawing of the plan). Times are seconds since the run began. Of long runs
/// every n-th row is in it, and `stride` says so.
[[nodiscard]] nlohmann::ordered_json plotData(const RunRecord& run, const std::vector<evaluation::ErrorAt>& errors,
                                              const PlanView& plan);

}  // namespace wardslam::report
