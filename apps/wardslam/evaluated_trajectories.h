#pragma once

#include <filesystem>
#include <optional>

#include "wardslam/core/trajectory.h"

namespace wardslam::apps {

/// A trajectory and the truth, by one clock.
struct EvaluatedTrajectories {
  core::Trajectory groundTruth;
  core::Trajectory estimate;
  std::optional<double> rate_hz;  ///< At which the ground truth's numbers of images were turned into time.
};

/// Reads both; where only one numbers images instead of telling the time, by `rate_hz` or 30 a second, as long as the
/// lengths of both agree with that. What had to be assumed is told on standard error. Throws core::InputError.
[[nodiscard]] EvaluatedTrajectories readEvaluated(const std::filesystem::path& groundTruth,
                                                  const std::filesystem::path& estimate, std::optional<double> rate_hz);

}  // namespace wardslam::apps
