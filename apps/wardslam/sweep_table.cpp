#include "sweep_table.h"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "wardslam/core/errors.h"
#include "wardslam/evaluation/absolute_trajectory_error.h"
#include "wardslam/exchange/tum_trajectory.h"

namespace wardslam::apps {
namespace {

struct Column {
  const char* heading;
  const char* path;  ///< Of the figure in summary.json.
};

constexpr Column kColumns[] = {
    {"coverage", "/coverage"},
    {"key points marked", "/dynamic_keypoint_fraction"},
    {"static key points kept", "/dynamic/keypoints/spared"},
    {"moving key points marked", "/dynamic/keypoints/recall"},
    {"pixel precision", "/dynamic/pixels/precision"},
    {"pixel recall", "/dynamic/pixels/recall"},
    {"true positive pixels", "/dynamic/pixels/true_positives"},
    {"false positive pixels", "/dynamic/pixels/false_positives"},
};
constexpr const char* kUnknown = "-";

std::string text(double value, int decimals) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(decimals) << value;
  return out.str();
}

std::string figure(const nlohmann::json& summary, const char* path) {
  const nlohmann::json::json_pointer pointer(path);
  if (!summary.contains(pointer) || summary.at(pointer).is_null()) return kUnknown;
  const auto& value = summary.at(pointer);
  return value.is_number_integer() ? value.dump() : text(value.get<double>(), 4);
}

nlohmann::json readSummary(const std::filesystem::path& file) {
  std::ifstream in(file);
  auto summary = nlohmann::json::parse(in, nullptr, false);
  if (summary.is_discarded())
    throw core::InputError(file.string() + ": not a summary; delete it to run this cell anew");
  return summary;
}

std::string trajectoryError(const std::filesystem::path& groundTruth, const std::filesystem::path& trajectory) {
  if (groundTruth.empty()) return kUnknown;
  const auto truth = exchange::readTumTrajectory(groundTruth);
  try {
    const auto error = evaluation::absoluteTrajectoryError(truth, exchange::readTumTrajectory(trajectory));
    return text(error.translation_m.rmse, 5);
  } catch (const core::InputError&) {
    return kUnknown;  // too little was tracked; the coverage says so
  }
}

std::string quoted(std::string value) {
  std::replace(value.begin(), value.end(), '"', '\'');
  return value.find_first_of(",\n") == std::string::npos ? value : '"' + value + '"';
}

}  // namespace

SweepTable::SweepTable(const std::vector<SweptParameter>& parameters, const std::vector<SweepRow>& rows,
                       const std::filesystem::path& groundTruth) {
  for (const SweptParameter& parameter : parameters) headings_.push_back(parameter.name);
  headings_.emplace_back("ATE [m]");
  for (const Column& column : kColumns) headings_.emplace_back(column.heading);
  headings_.emplace_back("note");
  for (const SweepRow& row : rows) {
    std::vector<std::string> line = row.cell;
    const bool hasResults = !row.results.empty();
    const auto summary = hasResults ? readSummary(row.results / "summary.json") : nlohmann::json::object();
    line.push_back(hasResults ? trajectoryError(groundTruth, row.results / "trajectory.txt") : kUnknown);
    for (const Column& column : kColumns) line.push_back(figure(summary, column.path));
    line.push_back(row.note);
    cells_.push_back(line);
  }
}

std::string SweepTable::csv() const {
  std::string out;
  const auto add = [&](const std::vector<std::string>& line) {
    for (std::size_t i = 0; i < line.size(); ++i)
      out += (i > 0 ? "," : "") + (line[i] == kUnknown ? "" : quoted(line[i]));
    out += "\n";
  };
  add(headings_);
  for (const auto& line : cells_) add(line);
  return out;
}

std::string SweepTable::markdown() const {
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i < headings_.size(); ++i) {
    widths.push_back(headings_[i].size());
    for (const auto& line : cells_) widths[i] = std::max(widths[i], line[i].size());
  }
  std::string out;
  const auto add = [&](const std::vector<std::string>& line) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      out += "| " + line[i] + std::string(widths[i] - line[i].size() + 1, ' ');
    }
    out += "|\n";
  };
  add(headings_);
  for (const std::size_t width : widths) out += "|" + std::string(width + 2, '-');
  out += "|\n";
  for (const auto& line : cells_) add(line);
  return out;
}

}  // namespace wardslam::apps
