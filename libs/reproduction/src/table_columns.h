#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "wardslam/reproduction/plan.h"
#include "wardslam/reproduction/published_figures.h"
#include "wardslam/reproduction/results.h"
#include "wardslam/reproduction/table.h"

namespace wardslam::reproduction {

inline double ateRmse(const RunResult& run) { return run.ate_rmse_m; }
inline double ateMean(const RunResult& run) { return run.ate_mean_m; }
inline double ateMedian(const RunResult& run) { return run.ate_median_m; }
inline double ateStd(const RunResult& run) { return run.ate_std_m; }
inline double ateSim3(const RunResult& run) { return run.ate_sim3_rmse_m; }
inline double rpeTranslation(const RunResult& run) { return run.rpe_translation_mps; }
inline double rpeRotation(const RunResult& run) { return run.rpe_rotation_degps; }
inline double coverage(const RunResult& run) { return run.coverage; }
inline double filterTime(const RunResult& run) { return run.filter_ms; }
inline double frameTime(const RunResult& run) { return run.frame_ms; }

inline bool isMain(const Variant& variant) { return variant.isMain(); }

/// What the tables are made of, column by column.
class Tables {
 public:
  struct PublishedColumn {
    const char* suffix;  ///< Of the heading.
    const char* figure;  ///< As PublishedSystem::of() knows it.
  };
  struct OwnColumn {
    const char* suffix;
    double (*figure)(const RunResult&);
    int decimals;
  };

  Tables(const Plan& plan, const std::vector<PublishedSystem>& published, const Results& results)
      : plan_(plan), published_(published), results_(results) {}

  /// A row for every sequence, and before them one for each of `cases`, which have published figures alone.
  [[nodiscard]] Table begin(const std::string& name, const std::string& title,
                            const std::vector<std::string>& cases = {}) const;

  /// Of each system that stands in that table and has figures of one of the rows.
  void addPublished(Table& table, int number, std::initializer_list<PublishedColumn> columns) const;

  /// Of each variant that is wanted; where there is no result, why.
  void addOwn(Table& table, const std::function<bool(const Variant&)>& isWanted,
              std::initializer_list<OwnColumn> columns) const;

  [[nodiscard]] std::string ownCell(std::size_t sequence, std::size_t variant, const OwnColumn& column) const;
  [[nodiscard]] const Plan& plan() const { return plan_; }
  [[nodiscard]] const Results& results() const { return results_; }

 private:
  const Plan& plan_;
  const std::vector<PublishedSystem>& published_;
  const Results& results_;
};

}  // namespace wardslam::reproduction
