#pragma once

#include <cstddef>
#include <map>

#include "wardslam/core/event_counts.h"
#include "wardslam/pipeline/frame_observer.h"

namespace wardslam::pipeline {

/// How old masks were when they were used, over the frames that had any.
struct MaskAge {
  int median_frames = 0;
  int p95_frames = 0;
  int median_ms = 0;
  int p95_ms = 0;
};

/// Counts what a run was made of.
class RunStatistics : public FrameObserver {
 public:
  void onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) override;

  /// An observation that never became a frame.
  void addUnusable();

  [[nodiscard]] std::size_t unusableFrames() const { return unusableFrames_; }

  [[nodiscard]] std::size_t frames() const { return frames_; }
  [[nodiscard]] std::size_t framesTracked() const { return framesTracked_; }
  [[nodiscard]] double coverage() const;  ///< Share of the frames with a pose; 0 without frames.
  [[nodiscard]] std::size_t lostEvents() const { return lostEvents_; }  ///< Times tracking went from ok to lost.
  [[nodiscard]] std::size_t framesHeldByDepth() const { return framesHeldByDepth_; }  ///< With too few key points.
  [[nodiscard]] std::size_t keyframes() const { return keyframes_; }
  [[nodiscard]] double readout_s() const { return readout_s_; }  ///< OdometryResult::readout_s, the last.
  [[nodiscard]] double dynamicKeypointFraction() const;          ///< Over all frames; 0 without key points.
  [[nodiscard]] const core::EventCounts& events() const { return events_; }
  [[nodiscard]] MaskAge maskAge() const;

 private:
  std::size_t frames_ = 0;
  std::size_t unusableFrames_ = 0;
  std::size_t framesTracked_ = 0;
  std::size_t lostEvents_ = 0;
  std::size_t framesHeldByDepth_ = 0;
  double readout_s_ = 0.0;
  std::size_t keyframes_ = 0;
  std::size_t keypoints_ = 0;
  std::size_t dynamicKeypoints_ = 0;
  odometry::State state_ = odometry::State::Initialising;
  core::EventCounts events_;
  std::map<int, std::size_t> framesByMaskAge_frames_;
  std::map<int, std::size_t> framesByMaskAge_ms_;
};

}  // namespace wardslam::pipeline
