#include "support/playback_clock.h"

#include <gtest/gtest.h>

namespace wardslam::apps {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

TEST(PlaybackClock, LetsAsMuchTimePassAsWasRecorded) {
  PlaybackClock clock;
  const auto start = Clock::now();
  for (int i = 0; i <= 5; ++i) clock.waitFor(1000.0 + 0.02 * i);
  EXPECT_GE(secondsSince(start), 0.1);
}

TEST(PlaybackClock, MakesUpForTimeLostMeanwhile) {
  PlaybackClock clock;
  const auto start = Clock::now();
  clock.waitFor(10.0);
  while (secondsSince(start) < 0.1) {
  }
  clock.waitFor(10.05);  // is over already
  clock.waitFor(10.2);
  EXPECT_GE(secondsSince(start), 0.2);
}

TEST(PlaybackClock, GoesOnAfterGapsAndStampsThatGoBack) {
  PlaybackClock clock;
  clock.waitFor(1000.0);
  clock.waitFor(1e9);  // would not return in a lifetime
  const auto start = Clock::now();
  clock.waitFor(1e9 + 0.05);
  EXPECT_GE(secondsSince(start), 0.04) << "the clock runs again";
  clock.waitFor(5.0);
  clock.waitFor(1e9);
}

}  // namespace
}  // namespace wardslam::apps
