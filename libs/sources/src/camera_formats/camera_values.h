#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "wardslam/core/options.h"
#include "wardslam/sources/rgbd_camera.h"

/// What readers of calibrations have in common.
namespace wardslam::sources {

/// Throws core::InputError where the value is absent or no number.
[[nodiscard]] double numberAt(const core::ConfigNode& node, const std::string& key);
[[nodiscard]] double numberAt(const core::ConfigNode& node, const std::string& key, double otherwise);

/// A width or a height: whole pixels, no more than any image has. Throws core::InputError where it is none.
[[nodiscard]] int pixelsIn(double number, const core::ConfigNode& where);
[[nodiscard]] int pixelsAt(const core::ConfigNode& node, const std::string& key);

/// At least `least` numbers.
[[nodiscard]] std::vector<double> numbersAt(const core::ConfigNode& list, std::size_t least);

/// The first of these keys that is there; a node that does not exist where none is.
[[nodiscard]] core::ConfigNode firstChild(const core::ConfigNode& node, std::initializer_list<const char*> keys);

/// fx, fy, cx, cy from nine numbers, row by row.
void setMatrix(core::CameraModel& camera, const std::vector<double>& matrix);

/// k1 k2 p1 p2 k3 as OpenCV orders them. Throws core::InputError where there are more that are not 0.
void setPlumbBob(core::CameraModel& camera, const std::vector<double>& coefficients, const core::ConfigNode& where);

/// Throws core::InputError unless the name of the lens model is one that plumb_bob covers (or is empty).
void requirePlumbBob(const core::ConfigNode& model);

/// Units per metre, by whatever name the file gives them (depth_factor, DepthMapFactor, depth_scale, …); what is below
/// 1 is taken for metres per unit. 0: nothing.
[[nodiscard]] double depthFactorIn(const core::ConfigNode& root);

/// From fx, fy, cx and cy of a section; they must be there.
void setPinhole(core::CameraModel& camera, const core::ConfigNode& section);

}  // namespace wardslam::sources
