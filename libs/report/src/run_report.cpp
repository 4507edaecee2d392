#include "wardslam/report/run_report.h"

#include <utility>

#include "page.h"
#include "pictures.h"
#include "plan_view.h"
#include "plots.h"
#include "run_record.h"
#include "truth.h"
#include "wardslam/core/errors.h"

namespace wardslam::report {
namespace {

/// Nothing, and a sentence, where they cannot be laid over each other.
std::optional<Comparison> comparisonOf(const RunRecord& run, const ReportOptions& options,
                                       std::vector<std::string>& missing) {
  if (!options.groundTruth || run.trajectory.empty()) return std::nullopt;
  try {
    return compare(*options.groundTruth, run.trajectory);
  } catch (const core::InputError& error) {
    missing.push_back(std::string("The way is not compared with the truth: ") + error.what() + ".");
    return std::nullopt;
  }
}

/// What nobody asked the run for: told in the page alone.
std::vector<std::string> notAskedFor(const RunRecord& run, const ReportOptions& options) {
  std::vector<std::string> sentences;
  if (!options.groundTruth && options.troubles.empty()) {
    sentences.emplace_back("No true way is given (--ground-truth): errors are not known.");
  }
  if (run.pictures.empty()) sentences.emplace_back("The run wrote no pictures (--pictures).");
  return sentences;
}

}  // namespace

Report makeReport(const std::filesystem::path& runFolder, const ReportOptions& options) {
  const RunRecord run = readRun(runFolder, options.map);
  std::vector<std::string> missing = run.missing;
  missing.insert(missing.end(), options.troubles.begin(), options.troubles.end());
  const auto comparison = comparisonOf(run, options, missing);
  const Comparison none;
  const Comparison& compared = comparison ? *comparison : none;
  const PlanView plan(run, compared.truthInMap);
  std::string pictures = picturesOf(run, options.keepPeople, missing);
  auto plots = plotData(run, compared.ate.errors, plan);
  if (!std::filesystem::exists(options.plotLibrary / "dygraph.min.js")) {
    missing.emplace_back("Plots are missing: dygraphs is not installed (in Debian: libjs-dygraphs).");
  }
  Report report;
  report.missing = missing;
  for (auto& sentence : notAskedFor(run, options)) missing.push_back(std::move(sentence));
  report.html =
      assemblePage({run, comparison, plan.svg(), std::move(pictures), std::move(plots), missing, options.plotLibrary});
  return report;
}

}  // namespace wardslam::report
