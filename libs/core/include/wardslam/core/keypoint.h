#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "wardslam/core/depth_noise.h"

namespace wardslam::core {

/// What the filters found out about a key point. Dynamic points take no part in tracking or mapping.
enum class Motion : std::uint8_t { Static, Dynamic };

/// An ORB key point with its depth.
struct Keypoint {
  cv::Point2f raw_px;          ///< Where it was found in the image as recorded.
  cv::Point2f undistorted_px;  ///< Where an ideal pinhole camera would have seen it.
  float depth_m = 0.0F;        ///< Depth along the optical axis; 0 = none measured.
  float depthSpread_m = 0.0F;  ///< How far (RMS) the depths of the 3 x 3 pixels around it are from it: large at edges.
  float angle_rad = 0.0F;      ///< Gray-centroid orientation, Eq. 5 (P5): atan2(m01, m10), image axes.
  float response = 0.0F;       ///< Corner strength, comparable within one image only.
  float scale = 1.0F;          ///< Pixels of the full image per pixel of the pyramid level it was found on.
  Motion motion = Motion::Static;
  float staticProbability = 1.0F;  ///< How sure it is that a static point is static, 0..1; what it weighs in odometry.

  [[nodiscard]] bool hasDepth() const { return depth_m > 0.0F; }
};

/// Standard deviation of the depth of a key point: that of the sensor, and that the corner may be on the pixel beside.
[[nodiscard]] inline double depthSigma_m(const Keypoint& keypoint, const DepthNoise& noise) {
  return std::hypot(noise.sigma_m(static_cast<double>(keypoint.depth_m)), static_cast<double>(keypoint.depthSpread_m));
}

/// The semantic descriptor of a key point (P4): what surrounds it, as cells that are alike or differ; what they stand
/// for is known to their maker alone.
using SemanticDescriptor = std::vector<std::uint8_t>;

/// Makes the semantic descriptors of one image, each when it is asked for.
class SemanticDescriptorSource {
 public:
  virtual ~SemanticDescriptorSource() = default;
  /// Of equal length for all key points.
  [[nodiscard]] virtual SemanticDescriptor of(const Keypoint& keypoint) const = 0;
};

/// Key points and their ORB descriptors: row i of `descriptors` (CV_8UC1, 32 columns) belongs to keypoints[i].
struct Features {
  std::vector<Keypoint> keypoints;
  cv::Mat descriptors;
  std::shared_ptr<const SemanticDescriptorSource> semanticDescriptors = nullptr;  ///< Null: the key points have none.

  [[nodiscard]] std::size_t size() const { return keypoints.size(); }
};

/// Share (0..1) of the cells in which two semantic descriptors differ; nothing where they cannot be compared, as one is
/// empty or they are of different length.
[[nodiscard]] std::optional<double> differenceOf(const SemanticDescriptor& a, const SemanticDescriptor& b);

/// The features a filter has not marked dynamic: P_static = P_orb − P_dynamic (Eq. 9, P7).
[[nodiscard]] Features selectStatic(const Features& features);

}  // namespace wardslam::core
