#include "stretches.h"

#include <optional>

namespace wardslam::report {
namespace {

/// How a stretch ends with `frame`, which has a pose. `before`: the last frame before it that had one.
Ending endingBy(const pipeline::FrameRow& frame, const std::optional<pipeline::FrameRow>& before) {
  if (!before) return Ending::Begins;
  return frame.piece == before->piece ? Ending::Found : Ending::BegunAnew;
}

}  // namespace

std::vector<Stretch> stretchesWithoutPose(const std::vector<pipeline::FrameRow>& frames) {
  std::vector<Stretch> stretches;
  std::optional<pipeline::FrameRow> lastWithPose;
  bool isOpen = false;
  for (const auto& frame : frames) {
    const bool hasPose = frame.state == odometry::State::Ok;
    if (!hasPose && !isOpen) stretches.push_back({frame.stamp_s, frame.stamp_s, 0, Ending::NotAnymore});
    if (!hasPose) ++stretches.back().frames;
    if (isOpen || !hasPose) stretches.back().to_s = frame.stamp_s;
    if (isOpen && hasPose) stretches.back().ending = endingBy(frame, lastWithPose);
    if (hasPose) lastWithPose = frame;
    isOpen = !hasPose;
  }
  return stretches;
}

}  // namespace wardslam::report
