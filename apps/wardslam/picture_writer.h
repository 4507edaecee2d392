#pragma once

#include <cstddef>
#include <filesystem>

#include "wardslam/core/label_space.h"
#include "wardslam/pipeline/frame_observer.h"

namespace wardslam::apps {

/// Writes every n-th frame, annotated, as <folder>/<stamp>.jpg.
class PictureWriter : public pipeline::FrameObserver {
 public:
  /// `interval` 0: never. Makes the folder with the first picture.
  PictureWriter(std::filesystem::path folder, std::size_t interval, const core::LabelSpace& labels);

  /// Throws core::InputError when the picture cannot be written.
  void onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) override;

 private:
  std::filesystem::path folder_;
  std::size_t interval_;
  core::LabelSpace labels_;
};

}  // namespace wardslam::apps
