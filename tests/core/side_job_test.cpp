#include "wardslam/core/side_job.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>

namespace wardslam::core {
namespace {

void aMoment() { std::this_thread::sleep_for(std::chrono::milliseconds(20)); }

TEST(SideJob, HandsOverWhatTheWorkReturns) {
  SideJob<std::string> job;
  EXPECT_FALSE(job.isStarted());
  job.start([] { return std::string("done"); });
  EXPECT_TRUE(job.isStarted());
  EXPECT_EQ(job.take(), "done");
  EXPECT_FALSE(job.isStarted()) << "taken once";
}

TEST(SideJob, WorksBesideTheCaller) {
  SideJob<std::thread::id> job;
  job.start([] { return std::this_thread::get_id(); });
  EXPECT_NE(job.take(), std::this_thread::get_id());
}

TEST(SideJob, ThrowsWhatTheWorkThrew) {
  SideJob<void> job;
  job.start([] { throw std::runtime_error("no masks"); });
  EXPECT_THROW(job.take(), std::runtime_error);
}

TEST(SideJob, NeverWorksOnTwoPiecesAtOnce) {
  std::atomic<int> working{0};
  std::atomic<int> most{0};
  const auto work = [&] {
    most = std::max(most.load(), ++working);
    aMoment();
    --working;
  };
  SideJob<void> job;
  for (int i = 0; i < 3; ++i) job.start(work);
  job.take();
  EXPECT_EQ(most, 1);
}

TEST(SideJob, EndsBeforeTheObjectDoes) {
  bool isDone = false;
  {
    SideJob<void> job;
    job.start([&isDone] {
      aMoment();
      isDone = true;
    });
  }
  EXPECT_TRUE(isDone);
}

}  // namespace
}  // namespace wardslam::core
