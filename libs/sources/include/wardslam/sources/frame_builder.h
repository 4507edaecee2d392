#pragma once

#include <cstdint>
#include <memory>

#include "wardslam/core/frame.h"

namespace wardslam::sources {

/// Turns observations into frames: grey image, depth in metres, and depth registered to the colour image where the
/// observation says that the two cameras do not coincide.
class FrameBuilder {
 public:
  /// Keeps a reference to the observation in Frame::observation. Throws core::InputError when image and range
  /// image are missing, empty or of sizes that do not belong together.
  [[nodiscard]] core::Frame build(std::shared_ptr<mrpt::obs::CObservation3DRangeScan> observation);

 private:
  std::uint64_t nextIndex_ = 0;
};

}  // namespace wardslam::sources
