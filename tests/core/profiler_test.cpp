#include "wardslam/core/profiler.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <thread>
#include <vector>

namespace wardslam::core {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

std::size_t heapInUse_bytes() {
  const struct mallinfo2 heap = mallinfo2();
  return heap.uordblks + heap.hblkhd;
}

TEST(Profiler, KnowsNothingAtFirst) { EXPECT_TRUE(Profiler().statistics().empty()); }

TEST(Profiler, InterpolatesQuantiles) {
  Profiler profiler;
  for (int i = 100; i >= 1; --i) profiler.add("step", milliseconds(i));
  const Profiler::Statistics step = profiler.statistics().at("step");
  EXPECT_EQ(step.calls, 100U);
  EXPECT_NEAR(step.median_ms, 50.5, 1e-4);
  EXPECT_NEAR(step.p95_ms, 95.05, 1e-4);  // 0.95 * 99 = 94.05 steps above 1
  EXPECT_NEAR(step.total_ms, 5050.0, 1e-9);
}

TEST(Profiler, KeepsStepsApart) {
  Profiler profiler;
  profiler.add("a", milliseconds(1));
  profiler.add("b", milliseconds(2));
  EXPECT_NEAR(profiler.statistics().at("a").median_ms, 1.0, 1e-6);
  EXPECT_NEAR(profiler.statistics().at("b").p95_ms, 2.0, 1e-6);
}

TEST(Profiler, SumsUpWithoutQuantiles) {
  Profiler profiler;
  profiler.add("a", milliseconds(1));
  profiler.add("a", milliseconds(3));
  profiler.add("b", milliseconds(2));
  const auto totals = profiler.totals();
  ASSERT_EQ(totals.size(), 2U);
  EXPECT_EQ(totals.at("a").calls, 2U);
  EXPECT_NEAR(totals.at("a").total_ms, 4.0, 1e-9);
  EXPECT_NEAR(totals.at("b").total_ms, 2.0, 1e-9);
}

TEST(Profiler, ScopeCountsOneCall) {
  Profiler profiler;
  { const auto scope = profiler.measure("step"); }
  EXPECT_EQ(profiler.statistics().at("step").calls, 1U);
}

TEST(Profiler, LongRunsStayExactInSumAndCloseInQuantiles) {
  Profiler profiler;
  constexpr int kCalls = 10 * static_cast<int>(Profiler::kMaxSamples) + 17;
  for (int i = 0; i < kCalls; ++i) profiler.add("step", microseconds(i));
  const Profiler::Statistics step = profiler.statistics().at("step");
  EXPECT_EQ(step.calls, static_cast<std::size_t>(kCalls));
  EXPECT_NEAR(step.total_ms, 1e-3 * kCalls * (kCalls - 1.0) / 2.0, 1e-3);
  EXPECT_NEAR(step.median_ms, 1e-3 * kCalls * 0.5, 1e-3 * kCalls * 0.01);
  EXPECT_NEAR(step.p95_ms, 1e-3 * kCalls * 0.95, 1e-3 * kCalls * 0.01);
}

TEST(Profiler, MemoryDoesNotGrowWithTheRun) {
  Profiler profiler;
  for (std::size_t i = 0; i < Profiler::kMaxSamples; ++i) profiler.add("step", microseconds(1));
  const std::size_t before_bytes = heapInUse_bytes();
  for (std::size_t i = 0; i < 50 * Profiler::kMaxSamples; ++i) profiler.add("step", microseconds(1));
  EXPECT_LE(heapInUse_bytes(), before_bytes + Profiler::kMaxSamples * sizeof(float));
}

TEST(Profiler, ThreadsMayAddTogether) {
  Profiler profiler;
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&profiler] {
      for (int i = 0; i < 1000; ++i) profiler.add("step", milliseconds(1));
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(profiler.statistics().at("step").calls, 4000U);
}

}  // namespace
}  // namespace wardslam::core
