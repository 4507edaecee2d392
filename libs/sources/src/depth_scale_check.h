#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace mrpt::obs {
class CObservation3DRangeScan;
}

namespace wardslam::sources {

/// Watches the first depth images for a wrong unit: RGB-D cameras see rooms, not the tip of the nose nor the next
/// street.
class DepthScaleCheck {
 public:
  /// A sentence, once enough images were seen and most of what they measure lies nearer than 0.5 m or farther than 8 m;
  /// or a tenth nearer than 0.5 m and nothing farther than 1.5 m; or a tenth farther than 10 m.
  [[nodiscard]] std::optional<std::string> add(mrpt::obs::CObservation3DRangeScan& scan);

 private:
  std::size_t images_ = 0;
  std::size_t measured_ = 0;
  std::size_t near_ = 0;
  std::size_t notClose_ = 0;
  std::size_t far_ = 0;
  std::size_t beyond_ = 0;
};

}  // namespace wardslam::sources
