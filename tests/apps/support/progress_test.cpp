#include "support/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace wardslam::apps {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

TEST(Progress, SaysNothingWhenPiped) {
  std::ostringstream out;
  {
    Progress progress(out, false, "frame", 10);
    for (std::size_t i = 1; i <= 10; ++i) progress.update(i);
  }
  EXPECT_EQ(out.str(), "");
}

TEST(Progress, TellsCountRateAndTimeLeft) {
  std::ostringstream out;
  {
    Progress progress(out, true, "frame", 10);
    progress.update(4);
    EXPECT_THAT(out.str(), AllOf(HasSubstr("frame 4/10"), HasSubstr("frames/s"), HasSubstr("s left")));
  }
  EXPECT_THAT(out.str(), EndsWith("\n")) << "the line is ended with the work";
}

TEST(Progress, PromisesNoEndWhereTheTotalIsUnknown) {
  std::ostringstream out;
  Progress progress(out, true, "frame", std::nullopt);
  progress.update(4);
  EXPECT_THAT(out.str(), AllOf(HasSubstr("frame 4 "), Not(HasSubstr("left"))));
}

TEST(Progress, TellsTheShareWhereTheTotalIsUnknown) {
  std::ostringstream out;
  Progress progress(out, true, "frame", std::nullopt);
  progress.update(4, 0.25);
  EXPECT_THAT(out.str(), AllOf(HasSubstr("frame 4 (25 %)"), HasSubstr("frames/s"), HasSubstr("s left")));
}

TEST(Progress, SkipsUpdatesThatComeTooFastButNotTheLast) {
  std::ostringstream out;
  Progress progress(out, true, "frame", 100000);
  for (std::size_t i = 1; i <= 100000; ++i) progress.update(i);
  const std::string text = out.str();
  EXPECT_LT(std::count(text.begin(), text.end(), '\r'), 1000);
  EXPECT_THAT(text, HasSubstr("frame 100000/100000"));
}

TEST(Progress, MoreThanTheTotalIsNoTrouble) {
  std::ostringstream out;
  Progress progress(out, true, "frame", 1);
  progress.update(2);
  EXPECT_THAT(out.str(), AllOf(HasSubstr("frame 2/1"), Not(HasSubstr("left"))));
}

TEST(Progress, NothingDrawnLeavesNoEmptyLine) {
  std::ostringstream out;
  { Progress progress(out, true, "frame", 1); }
  EXPECT_EQ(out.str(), "");
}

}  // namespace
}  // namespace wardslam::apps
