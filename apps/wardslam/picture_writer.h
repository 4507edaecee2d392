#pragma once

#include <cstddef>
#include <filesystem>

#include "wardslam/core/label_space.h"
#include "wardslam/pipeline/frame_observer.h"

namespace wardslam::apps {

/// What of a run its pictures may show.
struct PictureOptions {
  std::size_t interval = 0;  ///< Every so many frames a picture; 0: never.
  bool keepsPeople = false;  ///< Else they are blanked, and all of an image in which nobody looked for people.
};

/// Writes every n-th frame, annotated, as <folder>/<stamp>.jpg. What an earlier run left there goes with the first one:
/// it may show people where this run does not.
class PictureWriter : public pipeline::FrameObserver {
 public:
  /// Makes the folder with the first picture.
  PictureWriter(std::filesystem::path folder, const PictureOptions& options, const core::LabelSpace& labels);

  /// Stamps are seconds since then (UNIX s).
  void setStampOrigin(double origin_s) { stampOrigin_s_ = origin_s; }

  /// Throws core::InputError when the picture cannot be written.
  void onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) override;

 private:
  std::filesystem::path folder_;
  PictureOptions options_;
  core::LabelSpace labels_;
  double stampOrigin_s_ = 0.0;
  bool hasFolder_ = false;
};

}  // namespace wardslam::apps
