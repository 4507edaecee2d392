#include "evaluated_trajectories.h"

#include "support/told_at_once.h"
#include "wardslam/core/errors.h"
#include "wardslam/exchange/tum_trajectory.h"

namespace wardslam::apps {
namespace {

constexpr double kUsualRate_hz = 30.0;

double spanOf(const core::Trajectory& trajectory) { return trajectory.back().stamp_s - trajectory.front().stamp_s; }

bool isAbout(double a, double b) { return a > 0.5 * b && a < 2.0 * b; }

/// Images a second by which `numbered` lasts as long as `timed`; nothing where its numbers are seconds.
std::optional<double> rateOf(const core::Trajectory& numbered, const core::Trajectory& timed, double rate_hz,
                             const std::filesystem::path& file) {
  const double ratio = spanOf(numbered) / spanOf(timed);
  if (isAbout(ratio, rate_hz)) return rate_hz;
  if (isAbout(ratio, 1.0)) return std::nullopt;
  throw core::InputError(file.string() +
                         ": counts by one, and neither seconds nor images at 30 a second last as long " +
                         "as the other trajectory; say with --rate how many images a second were taken");
}

}  // namespace

EvaluatedTrajectories readEvaluated(const std::filesystem::path& groundTruth, const std::filesystem::path& estimate,
                                    std::optional<double> rate_hz) {
  exchange::TrajectoryReading truthReading{tellAtOnce, rate_hz};
  exchange::TrajectoryReading estimateReading{tellAtOnce, rate_hz};
  const bool isTruthNumbered = exchange::numbersImages(groundTruth);
  const bool isEstimateNumbered = exchange::numbersImages(estimate);
  if (!rate_hz && isTruthNumbered != isEstimateNumbered) {
    const auto truth = exchange::readTumTrajectory(groundTruth);
    const auto other = exchange::readTumTrajectory(estimate);
    (isTruthNumbered ? truthReading : estimateReading).rate_hz = isTruthNumbered
                                                                     ? rateOf(truth, other, kUsualRate_hz, groundTruth)
                                                                     : rateOf(other, truth, kUsualRate_hz, estimate);
  }
  return {exchange::readTumTrajectory(groundTruth, truthReading),
          exchange::readTumTrajectory(estimate, estimateReading), truthReading.rate_hz};
}

}  // namespace wardslam::apps
