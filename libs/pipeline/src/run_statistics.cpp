#include "wardslam/pipeline/run_statistics.h"

#include <cmath>

#include "dynamic_keypoints.h"

namespace wardslam::pipeline {
namespace {

double ratio(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

/// The least value that the given share of the counted values does not exceed; 0 where none was counted.
int quantile(const std::map<int, std::size_t>& counts, double share) {
  std::size_t total = 0;
  for (const auto& [value, count] : counts) total += count;
  std::size_t passed = 0;
  for (const auto& [value, count] : counts) {
    passed += count;
    if (static_cast<double>(passed) >= share * static_cast<double>(total)) return value;
  }
  return 0;
}

}  // namespace

void RunStatistics::onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) {
  ++frames_;
  if (odometry.hasPose()) ++framesTracked_;
  if (odometry.isHeldByDepth) ++framesHeldByDepth_;
  readout_s_ = odometry.readout_s;
  if (odometry.keyframe) ++keyframes_;
  if (state_ == odometry::State::Ok && odometry.state == odometry::State::Lost) ++lostEvents_;
  state_ = odometry.state;

  const auto& keypoints = frame.features.keypoints;
  keypoints_ += keypoints.size();
  dynamicKeypoints_ += countDynamic(keypoints);
  core::accumulate(events_, frame.events);
  if (frame.segmentation.empty()) return;
  ++framesByMaskAge_frames_[frame.segmentationAge_frames];
  ++framesByMaskAge_ms_[static_cast<int>(std::lround(1e3 * frame.segmentationAge_s))];
}

MaskAge RunStatistics::maskAge() const {
  return {quantile(framesByMaskAge_frames_, 0.5), quantile(framesByMaskAge_frames_, 0.95),
          quantile(framesByMaskAge_ms_, 0.5), quantile(framesByMaskAge_ms_, 0.95)};
}

void RunStatistics::addUnusable() {
  ++frames_;
  ++unusableFrames_;
}

double RunStatistics::coverage() const { return ratio(framesTracked_, frames_); }

double RunStatistics::dynamicKeypointFraction() const { return ratio(dynamicKeypoints_, keypoints_); }

}  // namespace wardslam::pipeline
