#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>

#include "wardslam/core/camera_model.h"
#include "wardslam/core/event_counts.h"
#include "wardslam/core/keypoint.h"
#include "wardslam/core/pixel_label.h"
#include "wardslam/core/segmentation.h"

namespace mrpt::obs {
class CObservation3DRangeScan;
}

namespace wardslam::core {

/// One RGB-D picture on its way through the pipeline. Each step fills its part; images share memory when copied.
struct Frame {
  std::uint64_t index = 0;                                       ///< Running number within the run, from 0.
  double stamp_s = 0.0;                                          ///< UNIX time, UTC, of the colour image.
  CameraModel camera;                                            ///< Of the colour image; depth is registered to it.
  Eigen::Isometry3d T_base_cam = Eigen::Isometry3d::Identity();  ///< The colour camera on the robot.

  cv::Mat color_bgr;  ///< CV_8UC3, raw (not undistorted).
  cv::Mat gray;       ///< CV_8UC1, raw.
  cv::Mat depth_m;    ///< CV_32FC1, same size as gray, depth along the optical axis in metres, 0 = none.

  Features features;               ///< Filled by features::OrbExtractor; filters set Keypoint::motion.
  Segmentation segmentation;       ///< Filled by the filter that segments; empty otherwise.
  double segmentationAge_s = 0.0;  ///< How much older the image is that its masks were made from,
  int segmentationAge_frames = 0;  ///< and how many frames.

  /// What filters found, each adding to what those before it did; CV_8UC1 of the size of gray, or empty where none said
  /// anything. The observation is annotated from it once all of them are through.
  cv::Mat labelBits;  ///< Bit i = PixelLabel i.
  cv::Mat mayMove;    ///< Not 0 where something moves or is suspected of it.

  /// What the frame was built from. May be null in tests.
  std::shared_ptr<mrpt::obs::CObservation3DRangeScan> observation;

  EventCounts events;  ///< Trouble met while working on this frame.
};

/// Adds to Frame::mayMove. `mask`: CV_8UC1 of the size of the image, not 0 where something may move.
void addMayMove(Frame& frame, const cv::Mat& mask);

/// Adds to Frame::labelBits. `labelBits`: CV_8UC1 of the size of the image, bit i = PixelLabel i.
void addLabels(Frame& frame, const cv::Mat& labelBits);

/// Adds to what is known to move: PixelLabel::Dynamic, and Frame::mayMove. `mask`: CV_8UC1 of the size of the image,
/// not 0 where something moves.
void addDynamic(Frame& frame, const cv::Mat& mask);

/// The pixels labelled PixelLabel::Dynamic: CV_8UC1, 255 there, else 0; empty where no filter said anything.
[[nodiscard]] cv::Mat dynamicPixels(const Frame& frame);

}  // namespace wardslam::core
