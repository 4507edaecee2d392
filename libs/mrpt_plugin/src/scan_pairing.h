#pragma once

#include <optional>
#include <vector>

#include "wardslam/core/frame.h"
#include "wardslam/mrpt_plugin/observation_semantic_rgbd.h"
#include "wardslam/sources/frame_builder.h"

namespace mrpt::obs {
class CObservation3DRangeScan;
}

namespace wardslam::mrpt_plugin {

/// A scan with all that is known of it, and where it was taken.
struct PlacedFrame {
  core::Frame frame;
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
  bool isAnnotated = false;
  std::map<core::ClassId, std::string> classes{};  ///< Names that came with it.
};

/// Brings scans and the CObservationSemanticRGBD of the same time together, whichever comes first.
class ScanPairing {
 public:
  /// What is complete now: the scan before, if nothing more was said of it, and this one, if it was said before. Throws
  /// core::FrameError for a scan that cannot be used; the one before is complete all the same, see flush().
  [[nodiscard]] std::vector<PlacedFrame> put(const mrpt::obs::CObservation3DRangeScan& scan,
                                             const Eigen::Isometry3d& T_map_base);

  /// The scan it belongs to; nothing when that is still to come.
  [[nodiscard]] std::optional<PlacedFrame> put(const CObservationSemanticRGBD& semantic);

  /// The scan that still waits for something to be said of it, if one does.
  [[nodiscard]] std::optional<PlacedFrame> flush();

 private:
  sources::FrameBuilder frames_;
  std::optional<PlacedFrame> waiting_;
  std::optional<CObservationSemanticRGBD> early_;  ///< Came before its scan.
};

}  // namespace wardslam::mrpt_plugin
