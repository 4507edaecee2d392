#include "evaluated_trajectories.h"

#include <cmath>

#include "support/told_at_once.h"
#include "wardslam/core/errors.h"
#include "wardslam/exchange/tum_trajectory.h"

namespace wardslam::apps {
namespace {

namespace fs = std::filesystem;

constexpr double kUsualRate_hz = 30.0;

double spanOf(const core::Trajectory& trajectory) { return trajectory.back().stamp_s - trajectory.front().stamp_s; }

bool isAbout(double a, double b) { return a > 0.5 * b && a < 2.0 * b; }

/// Whether any time of one lies within the other, both in seconds.
bool overlap(double first_s, double last_s, const core::Trajectory& other) {
  return first_s <= other.back().stamp_s && other.front().stamp_s <= last_s;
}

/// A trajectory whose stamps number images, and what is known of the time besides.
struct Numbered {
  fs::path file;
  core::Trajectory poses;  ///< With the numbers for stamps.
  fs::path timedFile;
  core::Trajectory timed;
  fs::path images;  ///< rgb.txt beside the truth; empty: there is none.

  [[nodiscard]] double first() const { return poses.front().stamp_s; }
  [[nodiscard]] double last() const { return poses.back().stamp_s; }
};

/// Numbers from 0 or 1 on for as many moments as there are: the number of the first; nothing where they do not fit.
std::optional<std::size_t> firstNumber(const Numbered& numbered, std::size_t moments) {
  const auto count = static_cast<double>(moments);
  if (numbered.last() == count - 1.0) return 0;
  if (numbered.last() == count && numbered.first() >= 1.0) return 1;
  return std::nullopt;
}

core::Trajectory atMoments(const Numbered& numbered, const std::vector<double>& moments_s, std::size_t first,
                           const fs::path& from) {
  core::Trajectory poses = numbered.poses;
  for (core::StampedPose& pose : poses) pose.stamp_s = moments_s.at(static_cast<std::size_t>(pose.stamp_s) - first);
  tellAtOnce(numbered.file.string() + ": numbers the images instead of telling the time, as many as " + from.string() +
             " lists; their times are taken from there, in order");
  return poses;
}

std::vector<double> stampsOf(const core::Trajectory& trajectory) {
  std::vector<double> stamps_s;
  for (const core::StampedPose& pose : trajectory) stamps_s.push_back(pose.stamp_s);
  return stamps_s;
}

/// By the images beside the truth or the poses of the other trajectory, where there are as many.
std::optional<core::Trajectory> byOrder(const Numbered& numbered) {
  if (!numbered.images.empty()) {
    const auto moments_s = exchange::readTumStamps(numbered.images);
    const auto first = firstNumber(numbered, moments_s.size());
    if (first && overlap(moments_s.front(), moments_s.back(), numbered.timed))
      return atMoments(numbered, moments_s, *first, numbered.images);
  }
  const auto first = firstNumber(numbered, numbered.timed.size());
  if (!first) return std::nullopt;
  return atMoments(numbered, stampsOf(numbered.timed), *first, numbered.timedFile);
}

/// Images a second by which they last as long as the other trajectory; 1: the numbers are seconds.
std::optional<double> rateOf(const Numbered& numbered) {
  const double ratio = spanOf(numbered.poses) / spanOf(numbered.timed);
  if (isAbout(ratio, kUsualRate_hz)) return kUsualRate_hz;
  if (isAbout(ratio, 1.0)) return 1.0;
  return std::nullopt;
}

/// By a clock that began with the recording, to which a rate leads; else by the time of day.
bool startsAtZero(const core::Trajectory& trajectory) {
  return trajectory.front().stamp_s <= 10.0 * spanOf(trajectory);
}

core::Trajectory atRate(const Numbered& numbered, double rate_hz) {
  if (rate_hz == 1.0) return numbered.poses;
  tellAtOnce(numbered.file.string() + ": " + core::StampClock(core::StampUnit::Frames, rate_hz).sentencePart());
  core::Trajectory poses = numbered.poses;
  for (core::StampedPose& pose : poses) pose.stamp_s /= rate_hz;
  return poses;
}

core::Trajectory timed(const Numbered& numbered, std::optional<double>& rate_hz) {
  const std::optional<double> rate = rate_hz ? rate_hz : rateOf(numbered);
  if (rate && overlap(numbered.first() / *rate, numbered.last() / *rate, numbered.timed)) {
    if (*rate != 1.0) rate_hz = rate;
    return atRate(numbered, *rate);
  }
  if (rate_hz || startsAtZero(numbered.timed)) {
    if (rate_hz) return atRate(numbered, *rate_hz);
    throw core::InputError(numbered.file.string() +
                           ": counts by one, and neither seconds nor images at 30 a second last as long " +
                           "as the other trajectory; say with --rate how many images a second were taken");
  }
  if (auto poses = byOrder(numbered)) return std::move(*poses);
  throw core::InputError(numbered.file.string() + ": counts by one, but neither " + numbered.timedFile.string() +
                         " nor a list of images beside it (rgb.txt) has as many times; write the times of the " +
                         "images in place of their numbers");
}

}  // namespace

EvaluatedTrajectories readEvaluated(const fs::path& groundTruth, const fs::path& estimate,
                                    std::optional<double> rate_hz) {
  const bool isTruthNumbered = exchange::numbersImages(groundTruth);
  const bool isEstimateNumbered = exchange::numbersImages(estimate);
  if (isTruthNumbered == isEstimateNumbered) {
    const exchange::TrajectoryReading reading{tellAtOnce, rate_hz};
    return {exchange::readTumTrajectory(groundTruth, reading), exchange::readTumTrajectory(estimate, reading), rate_hz};
  }
  const fs::path images = groundTruth.parent_path() / "rgb.txt";
  Numbered numbered{isTruthNumbered ? groundTruth : estimate,
                    {},
                    isTruthNumbered ? estimate : groundTruth,
                    {},
                    fs::exists(images) ? images : fs::path()};
  numbered.timed = exchange::readTumTrajectory(numbered.timedFile, {tellAtOnce, {}});
  numbered.poses = exchange::readTumTrajectory(numbered.file, {tellAtOnce, {}});
  core::Trajectory poses = timed(numbered, rate_hz);
  if (isTruthNumbered) return {std::move(poses), std::move(numbered.timed), rate_hz};
  return {std::move(numbered.timed), std::move(poses), std::nullopt};
}

}  // namespace wardslam::apps
