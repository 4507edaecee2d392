#pragma once

#include <optional>

#include "wardslam/core/frame.h"
#include "wardslam/core/trajectory.h"
#include "wardslam/mapping/mapping_options.h"
#include "wardslam/mapping/view.h"
#include "wardslam/odometry/odometry.h"

namespace wardslam::pipeline {

/// Chooses the frames that show the semantic map something new: every keyframe, and others where the camera has moved,
/// turned or waited enough since the last one chosen.
class ViewSelection {
 public:
  /// `needsSegmentation`: frames without masks are left out, as somebody may be in them.
  ViewSelection(const mapping::ViewOptions& options, bool needsSegmentation)
      : options_(options), needsSegmentation_(needsSegmentation) {}

  /// The frame as a view of the map; nothing when it shows nothing new or has no pose. Shares the images.
  [[nodiscard]] std::optional<mapping::View> select(const core::Frame& frame, const odometry::OdometryResult& odometry);

  /// Frames that would have been chosen, and had no masks.
  [[nodiscard]] std::size_t withoutMasks() const { return withoutMasks_; }

 private:
  [[nodiscard]] bool showsSomethingNew(const core::Frame& frame, const odometry::OdometryResult& odometry) const;

  mapping::ViewOptions options_;
  bool needsSegmentation_;
  std::optional<core::StampedPose> last_;  ///< Chosen.
  std::size_t withoutMasks_ = 0;
};

}  // namespace wardslam::pipeline
