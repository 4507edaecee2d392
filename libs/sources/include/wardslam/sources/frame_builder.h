#pragma once

#include <cstdint>
#include <memory>

#include "wardslam/core/frame.h"

namespace wardslam::sources {

class StillImages;

/// Turns observations into frames: colour and grey image, and depth in metres, registered to the colour image where
/// the observation says that the two cameras do not coincide.
class FrameBuilder {
 public:
  FrameBuilder();
  ~FrameBuilder();
  FrameBuilder(FrameBuilder&&) noexcept;
  FrameBuilder& operator=(FrameBuilder&&) noexcept;

  /// What is known of the camera beside what its observations tell (ObservationSource::sensorTraits).
  void setSensorTraits(const core::SensorTraits& traits) { traits_ = traits; }

  /// Keeps a reference to the observation in Frame::observation; the colour image shares its memory. Depth that is
  /// farther than any such camera can see becomes 0. Throws core::FrameError when image or range image are missing,
  /// or have no calibration or not the size that it says, and for an image that is not as large as the first: filters
  /// and tracking compare images with those before them. Depth that stands still while colours go on is none; the
  /// frame counts it ("sources.depth_still"), and colour images that are repeated ("sources.image_repeated").
  [[nodiscard]] core::Frame build(std::shared_ptr<mrpt::obs::CObservation3DRangeScan> observation);

 private:
  class DepthConverter;

  void requireSameSize(const cv::Size& size_px);

  cv::Size size_px_;  ///< Of the first image; empty before it.
  std::uint64_t nextIndex_ = 0;
  core::SensorTraits traits_;
  std::unique_ptr<DepthConverter> depthConverter_;
  std::unique_ptr<StillImages> stillImages_;
};

}  // namespace wardslam::sources
