#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "wardslam/core/trajectory.h"

namespace wardslam::report {

/// Where Debian's libjs-dygraphs puts what plots are drawn with.
inline constexpr const char* kPlotLibrary = "/usr/share/javascript/dygraphs";

struct ReportOptions {
  std::filesystem::path map;                    ///< That the run went on in; empty: map.wardmap of the run's folder.
  std::optional<core::Trajectory> groundTruth;  ///< To compare with, of any frame.
  std::vector<std::string> troubles;            ///< Sentences on what the report lacks that only the caller knows.
  bool keepPeople = false;                      ///< Shows pictures although people are not blanked in them.
  std::filesystem::path plotLibrary = kPlotLibrary;
};

/// A page, and what it lacks.
struct Report {
  std::string html;                  ///< Complete in itself: nothing is loaded from elsewhere.
  std::vector<std::string> missing;  ///< A sentence each; in the page there are these, and what nobody asked for.
};

/// The poses of a run to compare with the truth: the corrected ones, or of a run that did not end (yet) those it has.
[[nodiscard]] std::filesystem::path trajectoryOf(const std::filesystem::path& runFolder);

/// What a run left in its folder (docs/run.md) as one page of HTML. Whatever is missing or damaged is told in the page
/// and the rest is shown. Throws core::InputError where the folder holds nothing of a run.
[[nodiscard]] Report makeReport(const std::filesystem::path& runFolder, const ReportOptions& options);

}  // namespace wardslam::report
