#pragma once

#include <Eigen/Core>
#include <vector>

namespace wardslam::mapping {

/// Groups of points in which each has another nearer than `gap_m`, as indices into `points_m`; every point is in one.
/// In the order of their first points.
[[nodiscard]] std::vector<std::vector<std::size_t>> euclideanClusters(const std::vector<Eigen::Vector3f>& points_m,
                                                                      double gap_m);

}  // namespace wardslam::mapping
