#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "parameter_grid.h"

namespace wardslam::apps {

/// What is known of one cell of a sweep.
struct SweepRow {
  GridCell cell;
  std::filesystem::path results;  ///< A RunFolder that is complete; empty: there is none.
  std::string note;               ///< Why there is none, or what was wrong.
};

/// The results side by side: error of the trajectory, key points kept, and how well what was marked as dynamic agrees
/// with the truth, as far as the runs were compared with it.
class SweepTable {
 public:
  /// Throws core::InputError when a result or the ground truth (may be empty: none) cannot be read.
  SweepTable(const std::vector<SweptParameter>& parameters, const std::vector<SweepRow>& rows,
             const std::filesystem::path& groundTruth);

  [[nodiscard]] std::string csv() const;
  [[nodiscard]] std::string markdown() const;

 private:
  std::vector<std::string> headings_;
  std::vector<std::vector<std::string>> cells_;
};

}  // namespace wardslam::apps
