#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "wardslam/core/camera_model.h"

/// How what past images show becomes evidence that something moves: in log-odds, ln (p / (1 − p)), 0 = nothing is
/// known. Points that are followed, depth of the scene and the surface of single things are all judged by this.
namespace wardslam::change {

/// What an image says about a place where a point should be.
enum class Seen : std::uint8_t {
  Unknown = 0,  ///< The place is out of view, hidden, or without depth.
  Same = 1,     ///< There is a surface.
  Through = 2,  ///< There is none: what was seen lies behind.
};

/// Smallest and largest depth (m) around a pixel: what a small error of the pose could show instead of it.
struct DepthRange {
  double nearest_m = 0.0;
  double farthest_m = 0.0;
};

/// Raw pixel at which a camera should show a point of its own frame; nothing where that is too near for a sensor.
[[nodiscard]] std::optional<Eigen::Vector2d> pixelOf(const Eigen::Vector3d& p_cam_m, const core::CameraModel& camera);

/// What an image that shows `shown` says about a point that should be there, at depth `z_m`. `ofPoint` and `ofImage`:
/// the noise of the sensors that measured the one and the other.
[[nodiscard]] Seen seenAt(double z_m, const DepthRange& shown, const core::DepthNoise& ofPoint,
                          const core::DepthNoise& ofImage);

/// How many points of a surface a past image saw, and through how many it saw.
class SurfaceTally {
 public:
  void add(Seen seen);

  /// Share of the points that are elsewhere; nothing where too few of them tell.
  [[nodiscard]] std::optional<double> changed() const;

 private:
  int same_ = 0;
  int through_ = 0;
};

/// Evidence of one past image about a surface. `changed`: share of it that is elsewhere since. `noise`: share that
/// seems to be though it is not. `baseline`: age of the image as a share of the window.
[[nodiscard]] double evidenceOfSurface(double changed, double noise, double baseline);

/// Evidence of one past image about a point that was followed from there: log-likelihood ratio of "moves" to "rests"
/// for a squared error in units of its noise, against the 99 % limit of what rests. `baseline`: as above.
[[nodiscard]] double evidenceOfError(double squaredError, double limit, double baseline);

/// Evidence of several past images about the same thing: seen moving once is moving, else the strongest sign of rest
/// counts. Start with 0.
[[nodiscard]] double combined(double evidence, double another);

/// What is known after the news of an image, within bounds. `kept`: share of what was known that still holds.
[[nodiscard]] double updated(double known, double kept, double news);

/// Probability from log-odds.
[[nodiscard]] double probabilityOf(double logOdds);

}  // namespace wardslam::change
