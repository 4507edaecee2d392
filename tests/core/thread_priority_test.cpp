#include "wardslam/core/thread_priority.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <thread>

namespace wardslam::core {
namespace {

/// Greater is less urgent.
int niceness() { return getpriority(PRIO_PROCESS, 0); }

TEST(ThreadPriority, FallsForTheCallingThreadAlone) {
  const int before = niceness();
  int inThread = before;
  std::thread([&] {
    lowerThreadPriority();
    inThread = niceness();
  }).join();
  EXPECT_GT(inThread, before);
  EXPECT_EQ(niceness(), before);
}

}  // namespace
}  // namespace wardslam::core
