#include "wardslam/pipeline/start_pose.h"

#include <array>
#include <cmath>
#include <optional>
#include <sstream>

#include "wardslam/core/errors.h"
#include "wardslam/mapping/floor_finder.h"

namespace wardslam::pipeline {
namespace {

/// The cloud and what is made of it have single precision, tracking solves about the origin: from 10 km on poses are
/// worse by millimetres, from 100 km on by centimetres.
constexpr double kFarthest_m = 1000.0;
constexpr double kQuaternionTolerance = 0.01;  // a quaternion written with two decimals is still one

std::optional<Eigen::Isometry3d> parsePose(const std::string& text) {
  std::istringstream numbers(text);
  std::array<double, 7> pose{};
  for (double& number : pose) numbers >> number;
  std::string rest;
  if (!numbers || numbers >> rest) return std::nullopt;
  const Eigen::Quaterniond rotation(pose[6], pose[3], pose[4], pose[5]);
  if (!(std::abs(rotation.norm() - 1.0) < kQuaternionTolerance)) return std::nullopt;
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = rotation.normalized().toRotationMatrix();
  T.translation() = Eigen::Vector3d(pose[0], pose[1], pose[2]);
  return T;
}

}  // namespace

void requireValid(const MapFrameOptions& options) {
  if (options.start_pose.empty()) return;
  const auto T = parsePose(options.start_pose);
  if (T && T->translation().norm() > kFarthest_m) {
    throw core::InputError("map_frame.start_pose: \"" + options.start_pose + "\" is more than " +
                           std::to_string(std::lround(kFarthest_m)) +
                           " m from the origin, where coordinates lose precision; count from a point of the building");
  }
  if (T) return;
  throw core::InputError("map_frame.start_pose: \"" + options.start_pose +
                         "\" is not a pose; give seven numbers, x y z in metres and a unit quaternion qx qy qz qw");
}

Eigen::Isometry3d startPose(const MapFrameOptions& options, const core::Frame& firstFrame) {
  requireValid(options);
  if (!options.start_pose.empty()) return *parsePose(options.start_pose);
  Eigen::Isometry3d T_start_cam = firstFrame.T_base_cam;
  if (options.level_with_floor) {
    T_start_cam = mapping::levelWithFloor(firstFrame.depth_m, firstFrame.camera, T_start_cam).value_or(T_start_cam);
  }
  return options.T_map_base ? *options.T_map_base * T_start_cam : T_start_cam;
}

}  // namespace wardslam::pipeline
