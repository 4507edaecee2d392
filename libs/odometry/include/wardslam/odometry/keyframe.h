#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "wardslam/core/camera_model.h"
#include "wardslam/core/ground_plane.h"
#include "wardslam/core/keypoint.h"
#include "wardslam/odometry/depth_view.h"

namespace wardslam::odometry {

using PointId = std::uint64_t;
using KeyframeId = std::uint64_t;

/// A map point recognised in a key point of a keyframe.
struct Sighting {
  PointId point = 0;
  std::size_t keypoint = 0;  ///< Index into Keyframe::features.
};

/// An image worth remembering: it saw something new.
struct Keyframe {
  KeyframeId id = 0;         ///< Counts up by one, from 1.
  std::uint32_t submap = 0;  ///< Keyframes of one submap share a frame; a new one begins when tracking starts anew.
  double stamp_s = 0.0;
  core::CameraModel camera;
  Eigen::Isometry3d T_map_cam = Eigen::Isometry3d::Identity();
  /// From the keyframe before, of the same submap; corrections of the map leave it as it is. Nothing for the first, and
  /// where nobody measured it: then T_map_cam alone tells.
  std::optional<Eigen::Isometry3d> T_previous_cam = std::nullopt;
  core::Features features;  ///< Static ones only.
  std::vector<Sighting> sightings;
  std::shared_ptr<const DepthView> depth = nullptr;  ///< Null: not known, as of maps that older versions wrote.
  std::optional<core::GroundPlane> ground;           ///< That its image shows, where somebody looked and there is one.
};

}  // namespace wardslam::odometry
