#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace wardslam::reproduction {

/// What one run came to; NaN: not known.
struct RunResult {
  double ate_rmse_m = std::numeric_limits<double>::quiet_NaN();
  double ate_mean_m = std::numeric_limits<double>::quiet_NaN();
  double ate_median_m = std::numeric_limits<double>::quiet_NaN();
  double ate_std_m = std::numeric_limits<double>::quiet_NaN();
  double ate_sim3_rmse_m = std::numeric_limits<double>::quiet_NaN();
  double rpe_translation_mps = std::numeric_limits<double>::quiet_NaN();
  double rpe_rotation_degps = std::numeric_limits<double>::quiet_NaN();
  double coverage = 0.0;                                        ///< Share of the images with a pose.
  double filter_ms = std::numeric_limits<double>::quiet_NaN();  ///< To find and leave out what moves, per image.
  double frame_ms = std::numeric_limits<double>::quiet_NaN();   ///< Tracking of an image, everything in it, median.
  std::string trouble;                                          ///< One sentence; empty: none.
};

/// From what `wardslam eval --json` printed (empty: it could not compare, `trouble` says why) and the run's
/// summary.json. Throws core::InputError when they are not what they should be.
[[nodiscard]] RunResult toRunResult(const std::string& evaluation, const std::string& summary,
                                    const std::string& trouble = {});

/// Of repetitions.
struct Spread {
  double median = std::numeric_limits<double>::quiet_NaN();  ///< Mean of the two in the middle where there are two.
  double min = std::numeric_limits<double>::quiet_NaN();
  double max = std::numeric_limits<double>::quiet_NaN();
  double mean = std::numeric_limits<double>::quiet_NaN();
  std::size_t known = 0;  ///< Repetitions that have the figure.
  std::size_t runs = 0;
};

/// NaN is counted in `runs` alone.
[[nodiscard]] Spread spreadOf(std::vector<double> values);

/// All runs there are, by sequence and variant of a plan.
class Results {
 public:
  void add(std::size_t sequence, std::size_t variant, RunResult result);

  /// Why there are no results of a sequence (with a variant): "missing", "no masks".
  void setAbsent(std::size_t sequence, std::size_t variant, std::string why);

  [[nodiscard]] const std::vector<RunResult>& of(std::size_t sequence, std::size_t variant) const;
  [[nodiscard]] std::string whyAbsent(std::size_t sequence, std::size_t variant) const;

  template <class Figure>
  [[nodiscard]] Spread spread(std::size_t sequence, std::size_t variant, Figure figure) const {
    std::vector<double> values;
    for (const RunResult& result : of(sequence, variant)) values.push_back(figure(result));
    return spreadOf(std::move(values));
  }

 private:
  std::map<std::pair<std::size_t, std::size_t>, std::vector<RunResult>> runs_;
  std::map<std::pair<std::size_t, std::size_t>, std::string> absent_;
};

}  // namespace wardslam::reproduction
