#include "map_merge_command.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <functional>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "support/interruption.h"
#include "support/program.h"
#include "support/progress.h"
#include "support/table.h"
#include "wardslam/core/errors.h"
#include "wardslam/pipeline/slam_options.h"

namespace wardslam::apps {
namespace {

using Json = nlohmann::ordered_json;
using Path = std::filesystem::path;

struct MergeArguments {
  std::vector<Path> maps;
  Path out;
  Path config;
  bool json = false;
};

struct AlignArguments {
  Path a;
  Path b;
  Path config;
  bool json = false;
};

pipeline::SlamOptions optionsFrom(const Path& config) {
  return config.empty() ? pipeline::SlamOptions{} : pipeline::readSlamOptions(config);
}

/// A line for every kind of work, from where that begins; looks for Ctrl-C as often as it is told of progress.
class ProgressLines {
 public:
  explicit ProgressLines(std::function<std::string()> whenInterrupted) : whenInterrupted_(std::move(whenInterrupted)) {}

  void operator()(const merging::Progress& progress) {
    if (interruption_.requested()) throw core::InputError("interrupted; " + whenInterrupted_());
    if (unit_ != progress.unit) {
      unit_ = progress.unit;
      before_ = progress.done == 0 ? 0 : progress.done - 1;
      line_.reset();  // ends its line
      line_ = std::make_unique<Progress>(std::cerr, standardErrorIsTerminal(), unit_, progress.total - before_);
    }
    line_->update(progress.done - before_);
  }

 private:
  std::function<std::string()> whenInterrupted_;
  InterruptionGuard interruption_;
  std::string unit_;
  std::size_t before_ = 0;
  std::unique_ptr<Progress> line_;
};

/// What somebody should know who has ended it.
std::string whatIsLeftOf(const Path& out) {
  const Path work = out.string() + ".merging";
  std::string left = out.string() + " was not written";
  if (std::filesystem::exists(work)) left += "; the same command goes on from where it was (" + work.string() + ")";
  return left;
}

Json toJson(const merging::MergeReport& report) {
  Json parts = Json::array();
  for (const auto& part : report.parts) parts.push_back({{"files", part.files}, {"keyframes", part.keyframes}});
  return {{"parts", parts}, {"places_found", report.placesFound}, {"notes", report.notes}};
}

void print(std::ostream& out, const merging::MergeReport& report) {
  for (const auto& part : report.parts) {
    out << (&part == &report.parts.front() ? "map: " : "a part by itself, as no place connects it: ") << part.fileList()
        << " (" << part.keyframes << " keyframes)\n";
  }
  out << "places of one map that others recognised: " << report.placesFound << "\n";
}

void merge(const MergeArguments& arguments) {
  if (arguments.maps.size() < 2) throw UsageError("map merge needs two maps or more");
  merging::MergeReport report;
  {
    ProgressLines progress([&] { return whatIsLeftOf(arguments.out); });
    report = merging::mergeMaps(arguments.maps, arguments.out, optionsFrom(arguments.config), std::ref(progress));
  }
  for (const std::string& note : report.notes) std::cerr << "wardslam: " << note << "\n";
  if (arguments.json) {
    std::cout << toJson(report).dump(2) << "\n";
  } else {
    print(std::cout, report);
  }
}

Json toJson(const std::optional<merging::Alignment>& alignment) {
  if (!alignment) return {{"found", false}};
  const Eigen::Vector3d t_m = alignment->T_a_b.translation();
  const Eigen::Quaterniond q(alignment->T_a_b.linear());
  Json covariance = Json::array();
  for (int row = 0; row < 6; ++row) {
    Json numbers = Json::array();
    for (int column = 0; column < 6; ++column) numbers.push_back(alignment->covariance(row, column));
    covariance.push_back(numbers);
  }
  return {{"found", true},
          {"one_frame", alignment->haveOneFrame},
          {"translation", {t_m.x(), t_m.y(), t_m.z()}},
          {"quaternion", {q.x(), q.y(), q.z(), q.w()}},
          {"covariance", covariance},
          {"looks", alignment->looks},
          {"misfit_m", alignment->misfit_m},
          {"misfit_rad", alignment->misfit_rad}};
}

void print(std::ostream& out, const merging::Alignment& alignment) {
  if (alignment.haveOneFrame) {
    out << "one frame: one of the maps is the other, gone on with\n";
    return;
  }
  constexpr int kDecimals = 3;
  constexpr double kDegrees = 180.0 / M_PI;
  const Eigen::Vector3d t_m = alignment.T_a_b.translation();
  const Eigen::AngleAxisd turn(alignment.T_a_b.linear());
  const Eigen::Vector3d turn_deg = kDegrees * turn.angle() * turn.axis();
  const Eigen::Matrix<double, 6, 1> sigma = alignment.covariance.diagonal().cwiseSqrt();
  const char* const axes[] = {"x", "y", "z"};
  Table table({"", "of B in A", "standard deviation"});
  for (int i = 0; i < 3; ++i)
    table.add({std::string(axes[i]) + " [m]", fixed(t_m[i], kDecimals), fixed(sigma[i], kDecimals)});
  for (int i = 0; i < 3; ++i) {
    table.add({std::string("turn about ") + axes[i] + " [deg]", fixed(turn_deg[i], kDecimals),
               fixed(kDegrees * sigma[3 + i], kDecimals)});
  }
  table.print(out);
  out << alignment.looks << " looks from one into the other, " << fixed(alignment.misfit_m, kDecimals) << " m and "
      << fixed(kDegrees * alignment.misfit_rad, kDecimals) << " deg off (root mean square)\n";
}

void align(const AlignArguments& arguments) {
  const auto alignment = alignWithProgress(arguments.a, arguments.b, arguments.config);
  if (arguments.json) {
    std::cout << toJson(alignment).dump(2) << "\n";
  } else if (alignment) {
    print(std::cout, *alignment);
  }
  if (!alignment)
    throw core::InputError("no place of " + arguments.a.string() + " is found in " + arguments.b.string());
}

void addConfig(CLI::App& command, Path& config) {
  command.add_option("--config", config, "configuration (YAML): how places are found, graph, map and knowledge");
}

}  // namespace

std::optional<merging::Alignment> alignWithProgress(const Path& a, const Path& b, const Path& config) {
  ProgressLines progress([] { return "nothing was written"; });
  return merging::align(a, b, optionsFrom(config), std::ref(progress));
}

void addMapMergeCommands(CLI::App& mapCommand) {
  CLI::App* mergeCommand =
      mapCommand.add_subcommand("merge", "Make one map of several, by the places that they have in common");
  const auto arguments = std::make_shared<MergeArguments>();
  mergeCommand->add_option("FILES", arguments->maps, "maps (.wardmap), in any order; they stay as they are")
      ->required();
  mergeCommand->add_option("-o,--out", arguments->out, "the map to write (.wardmap)")->required();
  addConfig(*mergeCommand, arguments->config);
  mergeCommand->add_flag("--json", arguments->json, "print JSON instead of text");
  mergeCommand->callback([arguments] { merge(*arguments); });

  CLI::App* alignCommand = mapCommand.add_subcommand(
      "align", "How map B lies in the frame of map A, with covariance, by the places that they have in common");
  const auto pair = std::make_shared<AlignArguments>();
  alignCommand->add_option("A", pair->a, "a map (.wardmap)")->required();
  alignCommand->add_option("B", pair->b, "another one")->required();
  addConfig(*alignCommand, pair->config);
  alignCommand->add_flag("--json", pair->json, "print JSON instead of a table");
  alignCommand->callback([pair] { align(*pair); });
}

}  // namespace wardslam::apps
