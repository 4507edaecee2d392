#pragma once

#include <cstddef>
#include <filesystem>

#include "wardslam/evaluation/detection_score.h"
#include "wardslam/pipeline/frame_observer.h"
#include "wardslam/segmentation/stamped_files.h"

namespace wardslam::apps {

/// Compares what the filters marked as dynamic with what truly moved: a folder of 8-bit PNGs named by the stamp of the
/// colour image, anything but 0 where the picture moves. Frames without such an image are left out.
class DynamicTruth : public pipeline::FrameObserver {
 public:
  /// `rate_hz`: of images that are named by their numbers. Throws core::InputError when the folder cannot be read or
  /// holds no such image.
  DynamicTruth(const std::filesystem::path& folder, double rate_hz);

  /// Throws core::InputError for an image that is damaged or of another size than the frame's.
  void onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) override;

  [[nodiscard]] std::size_t frames() const { return frames_; }  ///< That were compared.
  /// The pixels labelled as dynamic.
  [[nodiscard]] const evaluation::DetectionScore& pixels() const { return pixels_; }
  [[nodiscard]] const evaluation::DetectionScore& keypoints() const { return keypoints_; }

 private:
  std::filesystem::path folder_;
  segmentation::StampedFiles files_;
  std::size_t frames_ = 0;
  evaluation::DetectionScore pixels_;
  evaluation::DetectionScore keypoints_;
};

}  // namespace wardslam::apps
