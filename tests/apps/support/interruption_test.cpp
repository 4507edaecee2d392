#include "support/interruption.h"

#include <gtest/gtest.h>

#include <csignal>

namespace wardslam::apps {
namespace {

TEST(InterruptionGuard, NoticesCtrlCAndTermination) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const InterruptionGuard guard;
    EXPECT_FALSE(guard.requested());
    std::raise(signal);
    EXPECT_TRUE(guard.requested());
  }
}

TEST(InterruptionGuard, StartsAfresh) {
  {
    const InterruptionGuard guard;
    std::raise(SIGINT);
  }
  EXPECT_FALSE(InterruptionGuard().requested());
}

TEST(InterruptionGuardDeathTest, SecondRequestEndsTheProgram) {
  EXPECT_EXIT(
      {
        const InterruptionGuard guard;
        std::raise(SIGINT);
        std::raise(SIGINT);
      },
      testing::KilledBySignal(SIGINT), "");
}

TEST(InterruptionGuardDeathTest, WithoutAGuardSignalsDoWhatTheyAlwaysDid) {
  EXPECT_EXIT(
      {
        { const InterruptionGuard guard; }
        std::raise(SIGTERM);
      },
      testing::KilledBySignal(SIGTERM), "");
}

}  // namespace
}  // namespace wardslam::apps
