#include "synthesis/ordered_work.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace wardslam::synth {
namespace {

TEST(OrderedWork, ComesInOrderHoweverLongEachTakes) {
  OrderedWork<int> work(50, 4, [](std::size_t i) {
    std::this_thread::sleep_for(std::chrono::microseconds(i % 3 == 0 ? 900 : 10));
    return static_cast<int>(i * i);
  });
  for (int i = 0; i < 50; ++i) EXPECT_EQ(work.take(), i * i);
}

TEST(OrderedWork, RunsAheadByABoundedNumber) {
  std::atomic<int> made{0};
  OrderedWork<int> work(1000, 2, [&](std::size_t i) {
    ++made;
    return static_cast<int>(i);
  });
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(work.take(), i);
    EXPECT_LE(made, i + 1 + 4);
  }
}

TEST(OrderedWork, WhatAMakerThrowsIsThrown) {
  OrderedWork<int> work(10, 2, [](std::size_t i) -> int {
    if (i == 3) throw std::runtime_error("no third");
    return static_cast<int>(i);
  });
  EXPECT_THROW(
      {
        for (int i = 0; i < 10; ++i) static_cast<void>(work.take());
      },
      std::runtime_error);
}

TEST(OrderedWork, CanBeLeftHalfway) {
  OrderedWork<int> work(1000, 3, [](std::size_t i) { return static_cast<int>(i); });
  EXPECT_EQ(work.take(), 0);
}

}  // namespace
}  // namespace wardslam::synth
