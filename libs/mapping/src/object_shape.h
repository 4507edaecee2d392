#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "wardslam/mapping/map_object.h"

namespace wardslam::mapping {

/// Where a thing is and how large, by its points.
struct ObjectShape {
  Eigen::Vector3d centroid_m = Eigen::Vector3d::Zero();
  Eigen::AlignedBox3d box_m;
  OrientedBox orientedBox;
};

/// Gaps in the surface of one thing that was seen from few sides.
inline constexpr double kPartGap_m = 0.15;

/// Of points in a frame with z up. Groups of points that lie apart and hold less than a tenth of all are left out, then
/// boxes leave out the outermost hundredth on each side. The oriented box stands upright and is turned to the principal
/// axes of the points in plan view. `points_m` must not be empty.
[[nodiscard]] ObjectShape shapeOf(const std::vector<Eigen::Vector3f>& points_m, double gap_m);

}  // namespace wardslam::mapping
