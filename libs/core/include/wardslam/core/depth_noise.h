#pragma once

namespace wardslam::core {

/// Standard deviation of a Kinect's depth (m) at depth z (m): σ_z = 0.0012 + 0.0019 (z − 0.4)²
/// (Nguyen, Izadi, Lovell: "Modeling Kinect sensor noise for improved 3D reconstruction and tracking", 3DIMPVT 2012,
/// axial noise).
[[nodiscard]] constexpr double kinectDepthSigma_m(double z_m) { return 0.0012 + 0.0019 * (z_m - 0.4) * (z_m - 0.4); }

}  // namespace wardslam::core
