#include "support/playback_clock.h"

#include <thread>

namespace wardslam::apps {
namespace {

constexpr double kLongestGap_s = 1.0;  ///< So that an interrupted program ends soon.

}  // namespace

void PlaybackClock::waitFor(double stamp_s) {
  const double step_s = stamp_s - last_s_;
  last_s_ = stamp_s;
  if (!start_ || step_s < 0.0 || step_s > kLongestGap_s) {
    start_ = Start{stamp_s, Clock::now()};
    return;
  }
  const std::chrono::duration<double> elapsed(stamp_s - start_->stamp_s);
  std::this_thread::sleep_until(start_->time + std::chrono::duration_cast<Clock::duration>(elapsed));
}

}  // namespace wardslam::apps
