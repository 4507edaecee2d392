#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "wardslam/core/camera_model.h"

namespace wardslam::odometry {

/// The depth of an image, and what of it does not belong to the scene at rest. Either may be empty: nothing known.
struct DepthImage {
  cv::Mat depth_m;  ///< CV_32FC1, registered to the colour image as recorded; 0 = none.
  cv::Mat mayMove;  ///< CV_8UC1 of the same size, not 0 where something moves or may.
};

/// Depth coarse enough to be kept with every keyframe: of each square of the raw image the nearest and the farthest.
struct DepthView {
  int cell_px = 0;
  int columns = 0;
  int rows = 0;
  std::vector<std::uint16_t> nearest_mm;  ///< Per cell, row by row; 0: nothing is known of it.
  std::vector<std::uint16_t> farthest_mm;
};

/// Of an image without depth: no cells.
[[nodiscard]] DepthView makeDepthView(const DepthImage& image);

/// What a view says of a surface that is told to be somewhere.
enum class InDepth : std::uint8_t {
  Unknown,      ///< It is out of sight, or nothing was measured there.
  Agrees,       ///< There is one.
  SeenThrough,  ///< The camera saw what is behind it: it is not there.
  Hidden,       ///< It is behind what the camera saw.
};

/// `p_cam_m`: in the view's camera frame. Allows for noise of depth, and for poses that are not exact.
[[nodiscard]] InDepth lookUp(const DepthView& view, const core::CameraModel& camera, const Eigen::Vector3d& p_cam_m);

/// Whether an image can show a surface at this pixel and depth: nothing that may move covers it, and nothing measured
/// around it is nearer. Where nothing was measured, or of an image without depth, nobody knows: it can.
[[nodiscard]] bool maySee(const DepthImage& image, const Eigen::Vector2d& raw_px, double depth_m,
                          const core::DepthNoise& noise);

/// Counts of surfaces, by what a view says of them.
struct DepthAgreement {
  int agreeing = 0;
  int seenThrough = 0;
  int hidden = 0;
  int unknown = 0;

  void count(InDepth found);
  DepthAgreement& operator+=(const DepthAgreement& other);
  [[nodiscard]] int compared() const { return agreeing + seenThrough + hidden; }
  /// Share of those that could be seen which are not there; 0 where none could.
  [[nodiscard]] double contradiction() const;
  /// Share of all that is confirmed.
  [[nodiscard]] double overlap() const;
};

/// What `view` says of the surfaces that `other` saw, from a camera at `T_cam_other` in the view's camera frame.
[[nodiscard]] DepthAgreement compareDepth(const DepthView& view, const core::CameraModel& camera,
                                          const DepthView& other, const core::CameraModel& otherCamera,
                                          const Eigen::Isometry3d& T_cam_other);

}  // namespace wardslam::odometry
