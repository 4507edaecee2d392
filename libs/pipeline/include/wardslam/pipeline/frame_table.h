#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "wardslam/core/atomic_file.h"
#include "wardslam/pipeline/frame_observer.h"

namespace wardslam::pipeline {

/// What a run notes of a frame besides its pose.
struct FrameRow {
  double stamp_s = 0.0;
  odometry::State state = odometry::State::Initialising;
  std::size_t keypoints = 0;
  std::size_t dynamicKeypoints = 0;  ///< Of these, the ones left out.
  int inliers = 0;                   ///< Points the pose rests on.
  bool isHeldByDepth = false;
  bool isKeyframe = false;
  std::uint32_t piece = 0;  ///< Of the map, as known at the time.
};

/// A line of text (CSV) for every frame, written as the run goes: until finish() the lines are in "<file>.partial".
class FrameTable : public FrameObserver {
 public:
  /// Throws core::InputError when the file cannot be created.
  explicit FrameTable(const std::filesystem::path& file);

  /// Stamps are seconds since then (UNIX s).
  void setStampOrigin(double origin_s) { stampOrigin_s_ = origin_s; }

  void onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) override;

  /// Gives the file its name. Throws core::InputError when the disk did not take all of it.
  void finish() { file_.commit(); }

 private:
  core::AtomicFile file_;
  double stampOrigin_s_ = 0.0;
};

/// Reads such a file, in the order it has. A last line that is cut off, as of a run that was killed, is left out.
/// Throws core::InputError naming file and line.
[[nodiscard]] std::vector<FrameRow> readFrameTable(const std::filesystem::path& file);

}  // namespace wardslam::pipeline
