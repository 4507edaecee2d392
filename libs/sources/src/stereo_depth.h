#pragma once

#include <memory>

#include "wardslam/core/depth_noise.h"
#include "wardslam/sources/stereo_options.h"

namespace mrpt::obs {
class CObservation3DRangeScan;
class CObservationStereoImages;
}  // namespace mrpt::obs

namespace wardslam::sources {

/// Turns the pairs of one stereo camera into what an RGB-D camera would have recorded in the place of the left one:
/// its image, and depth found by semi-global matching (Hirschmüller: "Stereo processing by semiglobal matching and
/// mutual information", TPAMI 2008; OpenCV's variant). Pairs that are not rectified are rectified first.
class StereoDepth {
 public:
  /// Throws core::InputError where the options contradict each other.
  explicit StereoDepth(const StereoOptions& options);
  ~StereoDepth();

  /// The images of the pair must be in memory. The result shares those that need no change. Throws core::FrameError
  /// for a pair that cannot be used: an image or calibration is missing, sizes differ, or the cameras do not stand
  /// side by side with the right one on the right.
  [[nodiscard]] std::shared_ptr<mrpt::obs::CObservation3DRangeScan> convert(
      const mrpt::obs::CObservationStereoImages& pair);

  /// Of the pair converted last: σ_z = z² σ_d / (f b).
  [[nodiscard]] const core::DepthNoise& noise() const { return noise_; }

 private:
  class Matcher;

  StereoOptions options_;
  std::unique_ptr<Matcher> matcher_;  ///< For the calibration met last.
  core::DepthNoise noise_;
};

}  // namespace wardslam::sources
