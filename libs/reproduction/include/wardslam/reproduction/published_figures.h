#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace wardslam::reproduction {

/// A column of figures that somebody published.
struct PublishedSystem {
  std::string name;
  std::string source;     ///< Where the figures were read.
  std::string alignment;  ///< "SE(3)", "Sim(3)", or "" where the source does not say.
  bool gpu = false;
  std::vector<int> tables;  ///< Of the paper, those it stands in.
  /// By sequence, then by figure, with the digits that were published: "0.0104".
  std::map<std::string, std::map<std::string, std::string>> figures;

  /// "–" where there is none. `figure`: "ate_rmse_m", "ate_mean_m", "ate_median_m", "ate_std_m", "rpe_translation_mps",
  /// "rpe_rotation_degps", "filter_ms" (to find and leave out what moves, per image).
  [[nodiscard]] std::string of(const std::string& sequence, const std::string& figure) const;
  [[nodiscard]] bool isIn(int table) const;

  /// "DROID-W (GPU, Sim(3))"
  [[nodiscard]] std::string heading() const;
};

/// Throws core::InputError with file, line and key.
[[nodiscard]] std::vector<PublishedSystem> readPublishedFigures(const std::filesystem::path& file);

}  // namespace wardslam::reproduction
