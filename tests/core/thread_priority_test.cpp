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
  int inItsThread = before;
  std::thread([&] {
    lowerThreadPriority();
    inThread = niceness();
    std::thread([&] {
      lowerThreadPriority();
      inItsThread = niceness();
    }).join();
  }).join();
  EXPECT_GT(inThread, before);
  EXPECT_TRUE(inItsThread > inThread || inItsThread == 19) << "the same again; 19 is the least there is";
  EXPECT_EQ(niceness(), before);
}

}  // namespace
}  // namespace wardslam::core
