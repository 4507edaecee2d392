#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "bag_survey.h"
#include "wardslam/core/camera_model.h"

namespace wardslam::sources {

/// The cameras of a recording of ROS, and where they sit.
struct BagRig {
  core::CameraModel color;
  core::CameraModel depth;
  std::optional<Eigen::Isometry3d> T_depth_color;  ///< Nothing: depth is registered to colour.
  std::optional<Eigen::Isometry3d> T_base_color;   ///< Nothing: the camera is taken for the robot.
  std::string baseFrame;
  std::string assumed;  ///< The end of a sentence: what of this had to be assumed.
};

/// `given` replaces the calibration of the colour camera. Throws core::InputError where cameras are not calibrated, or
/// nothing tells from where depth was seen.
[[nodiscard]] BagRig rigOf(const BagSurvey& survey, const std::string& colorTopic, const std::string& depthTopic,
                           const std::optional<core::CameraModel>& given, const std::string& file);

}  // namespace wardslam::sources
