#pragma once

#include <filesystem>
#include <optional>

namespace CLI {
class App;
}

namespace wardslam::apps {

/// What of a run becomes a page.
struct ReportRequest {
  std::filesystem::path folder;       ///< That `wardslam run` wrote.
  std::filesystem::path out;          ///< Empty: report.html in the folder.
  std::filesystem::path map;          ///< That the run went on in; empty: the one in the folder.
  std::filesystem::path groundTruth;  ///< Empty: none.
  std::optional<double> rate_hz;      ///< Of a truth that numbers images.
  bool keepPeople = false;
};

/// Writes the page; what it lacks is told on standard error. Throws core::InputError.
void writeReport(const ReportRequest& request);

/// `wardslam report`: what a run found, as one page for a browser.
void addReportCommand(CLI::App& app);

}  // namespace wardslam::apps
