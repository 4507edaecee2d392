#include <mrpt/obs/CObservation3DRangeScan.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "tracked_recording.h"
#include "wardslam/core/mrpt_compat.h"
#include "wardslam/core/rotation_vector.h"
#include "wardslam/sources/observation_source.h"

/// measure_certainty RECORDING GROUNDTRUTH [CONFIG]: is a pose as unsure as it says? Of the way between two images,
/// half a second to ten seconds apart, and from the first image to each, the normalised estimation error squared
/// (NEES): the squared error by the covariance of both poses and what the map may have drifted between them. Were all
/// that errs independent and normal, its mean would be 6, and 95 % of the images within 1.24 and 14.45 (chi-square, 6
/// degrees of freedom). Without filters: for recordings of places without people.
namespace wardslam {
namespace {

constexpr std::array kApart_s = {0.5, 1.0, 2.0, 5.0, 10.0};
constexpr double kLow = 1.237;
constexpr double kHigh = 14.449;

using Vector6 = Eigen::Matrix<double, 6, 1>;

struct Pose {
  double stamp_s = 0.0;
  Eigen::Isometry3d T_map_cam;
  Eigen::Isometry3d T_world_cam;
  odometry::PoseCovariance covariance;
  odometry::PoseCovariance drift;
};

struct Nees {
  std::vector<double> all;
  std::vector<double> translation;
  std::vector<double> rotation;
};

double meanOf(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value / static_cast<double>(values.size());
  return sum;
}

double medianOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : values[values.size() / 2];
}

void add(const Pose& before, const Pose& now, Nees& nees) {
  const Eigen::Isometry3d step = before.T_map_cam.inverse() * now.T_map_cam;
  const Eigen::Isometry3d trueStep = before.T_world_cam.inverse() * now.T_world_cam;
  const Eigen::Isometry3d off = step.inverse() * trueStep;
  Vector6 error;
  error << off.translation(), core::rotationVectorOf(off.linear());
  const odometry::PoseCovariance ofBefore = odometry::transformed(before.covariance - before.drift, step);
  const odometry::PoseCovariance covariance = ofBefore + now.covariance + now.drift;
  if (Eigen::LLT<odometry::PoseCovariance>(covariance).info() != Eigen::Success)
    return;  // what was known of the way to the keyframe changed in between
  nees.all.push_back(error.dot(covariance.inverse() * error));
  nees.translation.push_back(error.head<3>().dot(covariance.topLeftCorner<3, 3>().inverse() * error.head<3>()));
  nees.rotation.push_back(error.tail<3>().dot(covariance.bottomRightCorner<3, 3>().inverse() * error.tail<3>()));
}

std::vector<Pose> track(const std::string& recording, const bench::Truth& truth, const std::string& config) {
  pipeline::SlamSystem slam(bench::trackingAlone(config));
  const auto source = sources::openSource(recording, {});
  std::vector<Pose> poses;
  while (const auto observation = source->next()) {
    const auto result = slam.process(observation);
    const double stamp_s = core::fromMrptTime(observation->timestamp);
    const Eigen::Isometry3d* T_world_cam = truth.at(stamp_s);
    if (!result.hasPose() || !result.covariance || T_world_cam == nullptr) continue;
    poses.push_back({stamp_s, result.T_map_cam, *T_world_cam, *result.covariance, result.drift});
  }
  return poses;
}

void tell(const std::string& what, const Nees& nees) {
  const auto within = std::count_if(nees.all.begin(), nees.all.end(), [](double n) { return n > kLow && n < kHigh; });
  const auto above = std::count_if(nees.all.begin(), nees.all.end(), [](double n) { return n >= kHigh; });
  const double count = std::max<double>(1.0, static_cast<double>(nees.all.size()));
  std::printf(
      "%s: %5zu pairs, NEES mean %6.2f, median %6.2f (5.35), within the band of 95 %%: %.3f, above: %.3f; "
      "translation %.2f, rotation %.2f (3)\n",
      what.c_str(), nees.all.size(), meanOf(nees.all), medianOf(nees.all), static_cast<double>(within) / count,
      static_cast<double>(above) / count, meanOf(nees.translation), meanOf(nees.rotation));
}

void run(const std::string& recording, const std::string& truthFile, const std::string& config) {
  const std::vector<Pose> poses = track(recording, bench::Truth(truthFile), config);
  std::printf("%s: %zu poses\n", recording.c_str(), poses.size());
  for (const double apart_s : kApart_s) {
    Nees nees;
    std::size_t before = 0;
    for (const Pose& now : poses) {
      while (before + 1 < poses.size() && poses[before + 1].stamp_s <= now.stamp_s - apart_s + bench::kSameImage_s)
        ++before;
      const double gap_s = now.stamp_s - poses[before].stamp_s;
      if (std::abs(gap_s - apart_s) < 0.5 * apart_s) add(poses[before], now, nees);
    }
    tell(std::to_string(apart_s).substr(0, 4) + " s apart", nees);
  }
  Nees fromFirst;
  for (std::size_t i = 1; i < poses.size(); ++i) add(poses.front(), poses[i], fromFirst);
  tell("from the first", fromFirst);
}

}  // namespace
}  // namespace wardslam

int main(int count, char** arguments) {
  return wardslam::bench::measure("measure_certainty", count, arguments, wardslam::run);
}
