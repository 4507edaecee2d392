#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "run_record.h"
#include "truth.h"

namespace wardslam::report {

/// Everything a page is made of.
struct PageContent {
  const RunRecord& run;
  const std::optional<Comparison>& comparison;
  std::string plan;              ///< SVG, or nothing.
  std::string pictures;          ///< HTML, or nothing.
  nlohmann::ordered_json plots;  ///< plotData()
  std::vector<std::string> missing;
  std::filesystem::path plotLibrary;  ///< Where dygraph.min.js and dygraph.min.css are.
};

[[nodiscard]] std::string assemblePage(const PageContent& content);

}  // namespace wardslam::report
