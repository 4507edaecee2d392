#pragma once

#include <chrono>
#include <optional>

namespace wardslam::apps {

/// Plays what was recorded no faster than it happened.
class PlaybackClock {
 public:
  /// Returns when as much time has passed since the first call as between its stamp and this one; at once when that
  /// is over already. Gaps in the recording, and stamps that go back, start the clock anew instead of being waited for.
  void waitFor(double stamp_s);

 private:
  using Clock = std::chrono::steady_clock;

  struct Start {
    double stamp_s = 0.0;
    Clock::time_point time;
  };

  std::optional<Start> start_;
  double last_s_ = 0.0;
};

}  // namespace wardslam::apps
