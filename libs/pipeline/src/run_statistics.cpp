#include "wardslam/pipeline/run_statistics.h"

#include <algorithm>

namespace wardslam::pipeline {
namespace {

double ratio(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

void RunStatistics::onFrame(const core::Frame& frame, const odometry::OdometryResult& odometry) {
  ++frames_;
  if (odometry.hasPose()) ++framesTracked_;
  if (odometry.keyframe) ++keyframes_;
  if (state_ == odometry::State::Ok && odometry.state == odometry::State::Lost) ++lostEvents_;
  state_ = odometry.state;

  const auto& keypoints = frame.features.keypoints;
  keypoints_ += keypoints.size();
  dynamicKeypoints_ += static_cast<std::size_t>(std::count_if(
      keypoints.begin(), keypoints.end(), [](const auto& k) { return k.motion == core::Motion::Dynamic; }));
  core::accumulate(events_, frame.events);
}

void RunStatistics::addUnusable() {
  ++frames_;
  ++unusableFrames_;
}

double RunStatistics::coverage() const { return ratio(framesTracked_, frames_); }

double RunStatistics::dynamicKeypointFraction() const { return ratio(dynamicKeypoints_, keypoints_); }

}  // namespace wardslam::pipeline
