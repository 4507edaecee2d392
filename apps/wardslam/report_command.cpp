#include "report_command.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "evaluated_trajectories.h"
#include "support/told_at_once.h"
#include "wardslam/core/atomic_file.h"
#include "wardslam/core/errors.h"
#include "wardslam/report/run_report.h"

namespace wardslam::apps {
namespace {

/// What is wrong with the truth costs the comparison, not the page.
void readGroundTruth(const ReportRequest& request, report::ReportOptions& options) {
  if (request.groundTruth.empty()) return;
  const auto trajectory = report::trajectoryOf(request.folder);
  if (!std::filesystem::exists(trajectory)) return;  // told by the report
  try {
    options.groundTruth = readEvaluated(request.groundTruth, trajectory, request.rate_hz).groundTruth;
  } catch (const core::InputError& error) {
    options.troubles.push_back("The way is not compared with the truth: " + std::string(error.what()) + ".");
  }
}

}  // namespace

void writeReport(const ReportRequest& request) {
  report::ReportOptions options;
  options.map = request.map;
  options.keepPeople = request.keepPeople;
  readGroundTruth(request, options);
  const report::Report report = report::makeReport(request.folder, options);
  core::writeFileAtomically(request.out.empty() ? request.folder / "report.html" : request.out, report.html);
  for (const std::string& sentence : report.missing) tellAtOnce("report: " + sentence);
}

void addReportCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "report", "Make one page for a browser of what a run found: map, errors, key points, times, pictures");
  const auto request = std::make_shared<ReportRequest>();
  command->add_option("DIR", request->folder, "the folder that `wardslam run` wrote (--out)")->required();
  command->add_option("-o,--output", request->out, "write the page here (DIR/report.html unless given)");
  command
      ->add_option("--ground-truth", request->groundTruth,
                   "true poses, TUM format, to lay the way over and to tell errors by")
      ->check(CLI::ExistingFile);
  command
      ->add_option("--rate", request->rate_hz,
                   "images a second, where the stamps of the truth number images (30 unless given)")
      ->check(CLI::PositiveNumber);
  command->add_option("--map", request->map, "the map (.wardmap) that the run went on in, where it is not in DIR")
      ->check(CLI::ExistingFile);
  command->add_flag("--keep-people", request->keepPeople,
                    "show pictures also where people are not blanked in them; else these are left out");
  command->callback([request] { writeReport(*request); });
}

}  // namespace wardslam::apps
