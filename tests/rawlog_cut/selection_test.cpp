#include "selection.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CSensoryFrame.h>

#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::rawlog_cut {
namespace {

using mrpt::obs::CObservationOdometry;

CObservationOdometry observation(const std::string& label, double stamp_s) {
  CObservationOdometry observation;
  observation.sensorLabel = label;
  observation.timestamp = core::toMrptTime(stamp_s);
  return observation;
}

Verdict judged(Judge& judge, const std::string& label, double stamp_s) {
  auto one = observation(label, stamp_s);
  return judge.judge(one);
}

Selection between(const std::string& from, const std::string& to) {
  Selection selection;
  selection.from = Moment::parse(from);
  selection.to = Moment::parse(to);
  return selection;
}

TEST(Moment, IsAbsoluteOrSinceTheBeginning) {
  EXPECT_EQ(Moment::parse("1305031102.175304").value_s, 1305031102.175304);
  EXPECT_FALSE(Moment::parse("1305031102.175304").isSinceBegin);
  EXPECT_EQ(Moment::parse("+12.5").value_s, 12.5);
  EXPECT_TRUE(Moment::parse("+12.5").isSinceBegin);
}

TEST(Moment, RefusesWhatIsNoTime) {
  for (const char* text : {"", "+", "12:30", "1e", "nan", "inf", "++1", "1 "}) {
    EXPECT_THROW(static_cast<void>(Moment::parse(text)), core::InputError) << text;
  }
}

TEST(Judge, KeepsBothEndsOfASpan) {
  Judge judge(between("1305031102.175304", "1305031103.000000"));
  EXPECT_EQ(judged(judge, "a", 1305031102.175303), Verdict::Nothing);
  EXPECT_EQ(judged(judge, "a", 1305031102.175304), Verdict::Whole);
  EXPECT_EQ(judged(judge, "a", 1305031103.0), Verdict::Whole);
  EXPECT_EQ(judged(judge, "a", 1305031103.000001), Verdict::Nothing);
}

TEST(Judge, CountsFromTheFirstObservationEvenIfItIsLeftOut) {
  Selection selection = between("+1", "+2");
  selection.remove = {"b"};
  Judge judge(selection);
  EXPECT_EQ(judged(judge, "b", 100.0), Verdict::Nothing);
  EXPECT_EQ(judged(judge, "a", 100.9), Verdict::Nothing);
  EXPECT_EQ(judged(judge, "a", 101.0), Verdict::Whole);
  EXPECT_EQ(judged(judge, "b", 101.5), Verdict::Nothing);
  EXPECT_EQ(judged(judge, "a", 102.0), Verdict::Whole);
  EXPECT_EQ(judged(judge, "a", 102.1), Verdict::Nothing);
}

TEST(Judge, KeepsOrRemovesByTheWholeLabel) {
  Selection selection;
  selection.keep = {"RGBD"};
  Judge keep(selection);
  EXPECT_EQ(judged(keep, "RGBD", 1), Verdict::Whole);
  EXPECT_EQ(judged(keep, "RGBD_SEM", 1), Verdict::Nothing);
  EXPECT_EQ(judged(keep, "", 1), Verdict::Nothing);

  Selection without;
  without.remove = {"RGBD"};
  Judge remove(without);
  EXPECT_EQ(judged(remove, "RGBD", 1), Verdict::Nothing);
  EXPECT_EQ(judged(remove, "RGBD_SEM", 1), Verdict::Whole);
}

TEST(Judge, TakesTheUnwantedOutOfSensoryFrames) {
  Selection selection;
  selection.remove = {"b"};
  Judge judge(selection);
  const auto frameOf = [](const std::vector<std::string>& labels) {
    mrpt::obs::CSensoryFrame frame;
    for (const auto& label : labels) frame.insert(std::make_shared<CObservationOdometry>(observation(label, 1)));
    return frame;
  };
  auto mixed = frameOf({"a", "b", "a"});
  EXPECT_EQ(judge.judge(mixed), Verdict::Part);
  ASSERT_EQ(mixed.size(), 2U);
  for (const auto& one : mixed) EXPECT_EQ(one->sensorLabel, "a");
  auto wanted = frameOf({"a", "a"});
  EXPECT_EQ(judge.judge(wanted), Verdict::Whole);
  auto unwanted = frameOf({"b"});
  EXPECT_EQ(judge.judge(unwanted), Verdict::Nothing);
}

TEST(Judge, KeepsWhatComesFromNoSensor) {
  Selection selection = between("10", "20");
  selection.keep = {"a"};
  Judge judge(selection);
  mrpt::obs::CObservationComment comment;
  EXPECT_EQ(judge.judge(comment), Verdict::Whole);

  mrpt::obs::CActionCollection actions;
  mrpt::obs::CActionRobotMovement2D move;
  move.timestamp = core::toMrptTime(15);
  actions.insert(move);
  EXPECT_EQ(judge.judge(actions), Verdict::Whole);
  actions.clear();
  move.timestamp = core::toMrptTime(25);
  actions.insert(move);
  EXPECT_EQ(judge.judge(actions), Verdict::Nothing) << "it is too late";
}

TEST(Judge, WhatHasNoTimeBelongsToAllTimes) {
  Judge judge(between("10", "20"));
  CObservationOdometry timeless;
  timeless.timestamp = INVALID_TIMESTAMP;
  EXPECT_EQ(judge.judge(timeless), Verdict::Whole);
}

}  // namespace
}  // namespace wardslam::rawlog_cut
