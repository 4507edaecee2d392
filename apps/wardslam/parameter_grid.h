#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "wardslam/core/options.h"

namespace wardslam::apps {

/// A parameter of the configuration and the values to try. Its name is the path to it, "odometry.min_inliers";
/// "filter.n" is short for parameter n of the SemanticDynamicFilter.
struct SweptParameter {
  std::string name;
  std::vector<std::string> values;
};

/// From "filter.n=5,21,55". Throws UsageError for anything else.
[[nodiscard]] SweptParameter parseSweptParameter(const std::string& text);

/// One value per parameter, in their order.
using GridCell = std::vector<std::string>;

/// Every combination of values; the last parameter changes fastest.
[[nodiscard]] std::vector<GridCell> combinations(const std::vector<SweptParameter>& parameters);

/// "filter.n=5,filter.delta=3"
[[nodiscard]] std::string nameOf(const std::vector<SweptParameter>& parameters, const GridCell& cell);

/// A whole configuration with the values of a cell. `configuration`: YAML with every option in effect, read from
/// `file`. Throws core::InputError for a parameter it does not have, and names the nearest it has.
[[nodiscard]] core::ConfigNode withParameters(const std::string& configuration, const std::filesystem::path& file,
                                              const std::vector<SweptParameter>& parameters, const GridCell& cell);

}  // namespace wardslam::apps
