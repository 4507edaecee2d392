// make_laser_rawlog RECORDING GROUNDTRUTH.txt OUT.rawlog: what a robot with a laser scanner and wheels would have
// recorded on the way of a camera, for MRPT's pf-localization: of every third image a CObservation2DRangeScan (the
// nearest depth between 0.1 and 1.5 m over the floor, whoever stands there) and a CObservationOdometry that says 3 %
// too much way and drifts by 1 degree a metre. The truth is used for the height and tilt of the camera, and for the
// way.

#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "wardslam/core/mrpt_compat.h"
#include "wardslam/core/view_rays.h"
#include "wardslam/exchange/tum_trajectory.h"
#include "wardslam/sources/frame_builder.h"
#include "wardslam/sources/observation_source.h"

namespace {

using namespace wardslam;

constexpr int kRays = 129;
constexpr double kHalfAperture_rad = 0.56;
constexpr double kLowest_m = 0.1;
constexpr double kHighest_m = 1.5;
constexpr float kFarthest_m = 6.0F;
constexpr int kEvery = 3;

/// On the floor below the camera, x ahead.
Eigen::Isometry3d baseBelow(const Eigen::Isometry3d& T_world_cam) {
  const Eigen::Vector3d ahead = T_world_cam.linear().col(2);
  Eigen::Isometry3d T_world_base = Eigen::Isometry3d::Identity();
  T_world_base.translation().head<2>() = T_world_cam.translation().head<2>();
  T_world_base.linear() = Eigen::AngleAxisd(std::atan2(ahead.y(), ahead.x()), Eigen::Vector3d::UnitZ()).matrix();
  return T_world_base;
}

mrpt::obs::CObservation2DRangeScan scanOf(const core::Frame& frame, const Eigen::Isometry3d& T_base_cam) {
  std::vector<float> nearest_m(kRays, kFarthest_m);
  const cv::Mat rays = core::viewRays(frame.camera);
  for (int row = 0; row < frame.depth_m.rows; row += 2) {
    for (int column = 0; column < frame.depth_m.cols; column += 2) {
      const double depth_m = frame.depth_m.at<float>(row, column);
      if (!(depth_m > 0.0)) continue;
      const auto& ray = rays.at<cv::Vec2f>(row, column);
      const Eigen::Vector3d p_m = T_base_cam * (depth_m * Eigen::Vector3d(ray[0], ray[1], 1.0));
      if (p_m.z() < kLowest_m || p_m.z() > kHighest_m) continue;
      const double share = (std::atan2(p_m.y(), p_m.x()) + kHalfAperture_rad) / (2.0 * kHalfAperture_rad);
      const auto at = static_cast<int>(std::lround(share * (kRays - 1)));
      if (at < 0 || at >= kRays) continue;
      float& range_m = nearest_m[static_cast<std::size_t>(at)];
      range_m = std::min(range_m, static_cast<float>(p_m.head<2>().norm()));
    }
  }
  mrpt::obs::CObservation2DRangeScan scan;
  scan.sensorLabel = "LASER";
  scan.timestamp = core::toMrptTime(frame.stamp_s);
  scan.aperture = static_cast<float>(2.0 * kHalfAperture_rad);
  scan.rightToLeft = true;
  scan.maxRange = kFarthest_m;
  scan.setSensorPose(mrpt::poses::CPose3D(0.0, 0.0, 0.3, 0.0, 0.0, 0.0));
  scan.resizeScan(kRays);
  for (std::size_t i = 0; i < nearest_m.size(); ++i) {
    scan.setScanRange(i, nearest_m[i]);
    scan.setScanRangeValidity(i, nearest_m[i] < kFarthest_m);
  }
  return scan;
}

/// Adds up what wheels say, who are wrong in the same way all the time.
class Wheels {
 public:
  mrpt::poses::CPose2D after(const Eigen::Isometry3d& T_world_base) {
    if (hasStarted_) {
      const mrpt::poses::CPose2D step(core::toMrpt(before_.inverse() * T_world_base));
      const double way_m = std::hypot(step.x(), step.y());
      pose_ = pose_ + mrpt::poses::CPose2D(1.03 * step.x(), 1.03 * step.y(), step.phi() + 0.0175 * way_m);
    }
    hasStarted_ = true;
    before_ = T_world_base;
    return pose_;
  }

 private:
  bool hasStarted_ = false;
  Eigen::Isometry3d before_ = Eigen::Isometry3d::Identity();
  mrpt::poses::CPose2D pose_;
};

void make(const std::string& recording, const std::string& truthFile, const std::string& out) {
  const auto truth = exchange::readTumTrajectory(truthFile);
  mrpt::io::CFileGZOutputStream stream;
  if (!stream.open(out)) throw std::runtime_error(out + ": cannot be written");
  auto archive = mrpt::serialization::archiveFrom(stream);
  const auto source = sources::openSource(recording, {});
  sources::FrameBuilder builder;
  Wheels wheels;
  for (int image = 0; const auto observation = source->next(); ++image) {
    if (image % kEvery != 0) continue;
    const core::Frame frame = builder.build(observation);
    const auto nearer = [&](const auto& a, const auto& b) {
      return std::abs(a.stamp_s - frame.stamp_s) < std::abs(b.stamp_s - frame.stamp_s);
    };
    const Eigen::Isometry3d T_world_cam = std::min_element(truth.begin(), truth.end(), nearer)->T_map_cam;
    const Eigen::Isometry3d T_world_base = baseBelow(T_world_cam);
    mrpt::obs::CObservationOdometry odometry;
    odometry.sensorLabel = "ODOMETRY";
    odometry.timestamp = core::toMrptTime(frame.stamp_s);
    odometry.odometry = wheels.after(T_world_base);
    archive << odometry << scanOf(frame, T_world_base.inverse() * T_world_cam);
  }
}

}  // namespace

int main(int count, char** arguments) try {
  if (count != 4) throw std::runtime_error("usage: make_laser_rawlog RECORDING GROUNDTRUTH.txt OUT.rawlog");
  make(arguments[1], arguments[2], arguments[3]);
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
