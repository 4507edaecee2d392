#include "wardslam/reproduction/results.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "wardslam/core/errors.h"

namespace wardslam::reproduction {
namespace {

using nlohmann::json;

/// NaN where it is null or absent.
double number(const json& root, const char* path) {
  const json::json_pointer pointer(path);
  if (!root.contains(pointer) || !root.at(pointer).is_number()) return std::numeric_limits<double>::quiet_NaN();
  return root.at(pointer).get<double>();
}

json parsed(const std::string& text, const char* what) {
  json root = json::parse(text, nullptr, false);
  if (!root.is_object()) throw core::InputError(std::string(what) + " is damaged");
  return root;
}

/// Waiting for masks is in it; what is done beside ORB is not.
double filterTime_ms(const json& summary) {
  if (number(summary, "/stages/filters.apply/calls") > 0.0) return number(summary, "/stages/filters.apply/median_ms");
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

RunResult toRunResult(const std::string& evaluation, const std::string& summary, const std::string& trouble) {
  RunResult result;
  result.trouble = trouble;
  const json run = parsed(summary, "summary.json");
  result.coverage = number(run, "/coverage");
  result.frame_ms = number(run, "/stages/pipeline.process/median_ms");
  result.filter_ms = filterTime_ms(run);
  if (evaluation.empty()) return result;
  const json errors = parsed(evaluation, "the evaluation");
  result.ate_rmse_m = number(errors, "/ate/rmse");
  result.ate_mean_m = number(errors, "/ate/mean");
  result.ate_median_m = number(errors, "/ate/median");
  result.ate_std_m = number(errors, "/ate/std");
  result.rpe_translation_mps = number(errors, "/rpe/translation_m_per_s/rmse");
  result.rpe_rotation_degps = number(errors, "/rpe/rotation_deg_per_s/rmse");
  result.ate_sim3_rmse_m = number(errors, "/ate_sim3/rmse");
  return result;
}

Spread spreadOf(std::vector<double> values) {
  Spread spread;
  spread.runs = values.size();
  values.erase(std::remove_if(values.begin(), values.end(), [](double value) { return std::isnan(value); }),
               values.end());
  spread.known = values.size();
  if (values.empty()) return spread;
  std::sort(values.begin(), values.end());
  spread.min = values.front();
  spread.max = values.back();
  spread.median = 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
  spread.mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  return spread;
}

void Results::add(std::size_t sequence, std::size_t variant, RunResult result) {
  runs_[{sequence, variant}].push_back(std::move(result));
}

void Results::setAbsent(std::size_t sequence, std::size_t variant, std::string why) {
  absent_[{sequence, variant}] = std::move(why);
}

const std::vector<RunResult>& Results::of(std::size_t sequence, std::size_t variant) const {
  static const std::vector<RunResult> kNone;
  const auto found = runs_.find({sequence, variant});
  return found == runs_.end() ? kNone : found->second;
}

std::string Results::whyAbsent(std::size_t sequence, std::size_t variant) const {
  const auto found = absent_.find({sequence, variant});
  return found == absent_.end() ? std::string() : found->second;
}

}  // namespace wardslam::reproduction
