#pragma once

#include <string>
#include <vector>

#include "run_record.h"

namespace wardslam::report {

/// Pictures of the run, so many of them, evenly chosen, as HTML; small enough to travel with the page. Where people are
/// not blanked in them, or nothing says that they are, there are none unless `keepPeople`, and `missing` gets a
/// sentence.
[[nodiscard]] std::string picturesOf(const RunRecord& run, bool keepPeople, std::vector<std::string>& missing);

/// Of `count` things, at most `most`, evenly spaced, with the first and the last.
[[nodiscard]] std::vector<std::size_t> evenlyChosen(std::size_t count, std::size_t most);

}  // namespace wardslam::report
