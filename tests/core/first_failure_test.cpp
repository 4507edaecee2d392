#include "wardslam/core/first_failure.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace wardslam::core {
namespace {

TEST(FirstFailure, TriesEverythingAndThrowsWhatFailedFirst) {
  FirstFailure failure;
  int tried = 0;
  failure.attempt([&] { ++tried; });
  EXPECT_FALSE(failure.hasFailed());
  EXPECT_NO_THROW(failure.rethrow());
  failure.attempt([] { throw std::logic_error("first"); });
  failure.attempt([] { throw std::runtime_error("second"); });
  failure.attempt([&] { ++tried; });
  EXPECT_TRUE(failure.hasFailed());
  EXPECT_THROW(failure.rethrow(), std::logic_error);
  EXPECT_EQ(tried, 2);
}

}  // namespace
}  // namespace wardslam::core
