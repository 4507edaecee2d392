#pragma once

#include <vector>

#include "wardslam/reproduction/plan.h"
#include "wardslam/reproduction/published_figures.h"
#include "wardslam/reproduction/results.h"
#include "wardslam/reproduction/table.h"

namespace wardslam::reproduction {

/// The paper's Tables 1 to 7 over the sequences of a plan: the figures that others published, where they have some of
/// these sequences, and those of the results; before them, as "runs", what was run and how much of it has a pose.
/// Tables 5 and 6 are made of variants that differ in n and delta, or in the test of match outliers, alone; without
/// any, and without published figures, they are left out.
[[nodiscard]] std::vector<Table> paperTables(const Plan& plan, const std::vector<PublishedSystem>& published,
                                             const Results& results);

/// Every figure of every sequence and variant, one a line, for programs: median, least, most, mean, repetitions.
[[nodiscard]] Table allFigures(const Plan& plan, const Results& results);

}  // namespace wardslam::reproduction
