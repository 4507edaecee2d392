#include "support/program.h"

#include <gtest/gtest.h>

namespace wardslam::apps {
namespace {

TEST(RunProgram, HandsTheExitCodeOn) {
  EXPECT_EQ(runProgram("tool", [] { return 0; }), kSuccess);
  EXPECT_EQ(runProgram("tool", [] { return 7; }), 7);
}

TEST(RunProgram, ErrorIsOneSentenceOnStandardError) {
  testing::internal::CaptureStderr();
  const int code = runProgram("tool", []() -> int { throw std::runtime_error("x.yaml:3: no such key"); });
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "tool: x.yaml:3: no such key\n");
  EXPECT_EQ(code, kFailure);
}

TEST(RunProgram, WrongUsageHasItsOwnCode) {
  testing::internal::CaptureStderr();
  const int code = runProgram("tool", []() -> int { throw UsageError("--masks and --model exclude each other"); });
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "tool: --masks and --model exclude each other\n");
  EXPECT_EQ(code, kWrongUsage);
}

}  // namespace
}  // namespace wardslam::apps
