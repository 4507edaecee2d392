#pragma once

#include <cstddef>
#include <vector>

#include "wardslam/odometry/keyframe.h"
#include "wardslam/odometry/keypoint_grid.h"
#include "wardslam/odometry/odometry_options.h"
#include "wardslam/odometry/orb_descriptor.h"

namespace wardslam::odometry {

/// A map point as it should appear in an image.
struct ProjectedPoint {
  PointId id = 0;
  const OrbDescriptor* descriptor = nullptr;
  Eigen::Vector2d undistorted_px = Eigen::Vector2d::Zero();
  double scale = 1.0;                                ///< Predicted Keypoint::scale.
  Eigen::Vector2d raw_px = Eigen::Vector2d::Zero();  ///< In the image as recorded.
  double depth_m = 0.0;
};

/// A map point by its looks alone.
struct DescribedPoint {
  PointId id = 0;
  const OrbDescriptor* descriptor = nullptr;
};

/// A map point and the key point in which it was recognised.
struct Match {
  PointId point = 0;
  std::size_t keypoint = 0;
};

/// Recognises map points in an image by their ORB descriptors.
class Matcher {
 public:
  explicit Matcher(const MatcherOptions& options) : options_(options) {}

  /// Looks for each projected point within `radius_px` × its scale around where it should be. A key point is given
  /// to the point that resembles it most.
  [[nodiscard]] std::vector<Match> searchNear(const std::vector<ProjectedPoint>& points, const core::Features& features,
                                              const KeypointGrid& grid, double radius_px) const;

  /// Looks for the points everywhere in the image: mutual best matches that pass the ratio test.
  [[nodiscard]] std::vector<Match> searchEverywhere(const std::vector<DescribedPoint>& points,
                                                    const core::Features& features) const;

 private:
  MatcherOptions options_;
};

}  // namespace wardslam::odometry
