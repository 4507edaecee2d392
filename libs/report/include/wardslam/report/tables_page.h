#pragma once

#include <string>

#include "wardslam/reproduction/table.h"

namespace wardslam::report {

/// What `reproduction::toMarkdown` says, as a page of HTML that is complete in itself: nothing is loaded from
/// elsewhere. Wide tables scroll beside their labels.
[[nodiscard]] std::string makeTablesPage(const reproduction::TableCollection& collection);

}  // namespace wardslam::report
