#include "wardslam/core/stamp_clock.h"

#include <gmock/gmock.h>

namespace wardslam::core {
namespace {

using ::testing::HasSubstr;

TEST(StampUnits, OfTodayAreKnownByTheirSize) {
  EXPECT_EQ(recogniseStampUnit({"1305031102.175304"}), StampUnit::Seconds);
  EXPECT_EQ(recogniseStampUnit({"1305031102175"}), StampUnit::Milliseconds);
  EXPECT_EQ(recogniseStampUnit({"1305031102175304"}), StampUnit::Microseconds);
  EXPECT_EQ(recogniseStampUnit({"1305031102175304000"}), StampUnit::Nanoseconds);
  EXPECT_EQ(recogniseStampUnit({"1305031102175304000.000000"}), StampUnit::Nanoseconds);  // ORB-SLAM3
  EXPECT_EQ(recogniseStampUnit({"1.305031102175304e18"}), StampUnit::Nanoseconds);
}

TEST(StampUnits, OfClocksThatBeganLatelyAreKnownByTheirSteps) {
  EXPECT_EQ(recogniseStampUnit({"0.0", "0.033", "0.067"}), StampUnit::Seconds);
  EXPECT_EQ(recogniseStampUnit({"0", "1", "2", "3"}), StampUnit::Frames);
  EXPECT_EQ(recogniseStampUnit({"0", "10", "20", "30"}), StampUnit::Frames);
  EXPECT_EQ(recogniseStampUnit({"722.000000", "723.000000", "724.000000", "725.000000", "726.000000", "727.000000",
                                "728.000000", "729.000000", "730.000000", "731.000000"}),
            StampUnit::Frames);
  EXPECT_EQ(recogniseStampUnit({"0.0", "1.0", "2.0", "3.0", "4.0", "5.0", "6.0", "7.0", "8.0", "9.0"}),
            StampUnit::Frames);
  EXPECT_EQ(recogniseStampUnit({"000015", "000040", "000060"}), StampUnit::Frames);
  EXPECT_EQ(recogniseStampUnit({"5000", "5033", "5067", "5100"}), StampUnit::Milliseconds);
  EXPECT_EQ(recogniseStampUnit({"0", "33366", "66733"}), StampUnit::Microseconds);
  EXPECT_EQ(recogniseStampUnit({"12000000000", "12033366000", "12066733000"}), StampUnit::Nanoseconds);
}

TEST(StampUnits, ThatCouldBeOneThingOrAnotherAreNotGuessed) {
  EXPECT_EQ(recogniseStampUnit({"0", "33", "66", "99"}), std::nullopt);
  EXPECT_EQ(recogniseStampUnit({"7", "95", "102", "400"}), std::nullopt);
}

TEST(StampUnits, OfWholeSecondsStaySeconds) {
  EXPECT_EQ(recogniseStampUnit({"1305031102", "1305031103", "1305031104"}), StampUnit::Seconds);
  EXPECT_EQ(recogniseStampUnit({"1305031102.0", "1305031103.0", "1305031104.0"}), StampUnit::Seconds);
  EXPECT_EQ(recogniseStampUnit({"1.0", "2.0", "3.0"}), StampUnit::Seconds);
  EXPECT_EQ(recogniseStampUnit({"0.00", "1.00", "2.01", "3.00", "4.00", "5.00", "6.00", "7.00", "8.00", "9.00"}),
            StampUnit::Seconds);
  EXPECT_EQ(recogniseStampUnit({"7"}), StampUnit::Seconds);
  EXPECT_EQ(recogniseStampUnit({}), StampUnit::Seconds);
}

TEST(StampClock, KeepsWhatADoubleCanHold) {
  EXPECT_DOUBLE_EQ(StampClock(StampUnit::Nanoseconds).seconds("1700000003333333333").value(), 1700000003.333333333);
  EXPECT_DOUBLE_EQ(StampClock(StampUnit::Nanoseconds).seconds("1700000003333333333.000").value(), 1700000003.333333333);
  EXPECT_DOUBLE_EQ(StampClock(StampUnit::Microseconds).seconds("1700000003333333").value(), 1700000003.333333);
  EXPECT_DOUBLE_EQ(StampClock(StampUnit::Milliseconds).seconds("1500.5").value(), 1.5005);
  EXPECT_DOUBLE_EQ(StampClock(StampUnit::Frames, 25.0).seconds("50").value(), 2.0);
  EXPECT_EQ(StampClock().seconds("1305031102.175304").value(), 1305031102.175304);
}

TEST(StampClock, ReadsFiniteNumbersOnly) {
  for (const char* word : {"", "a", "1.5x", "nan", "inf", "1e999"}) {
    EXPECT_EQ(StampClock().seconds(word), std::nullopt) << word;
    EXPECT_EQ(StampClock(StampUnit::Nanoseconds).seconds(word), std::nullopt) << word;
  }
}

TEST(StampClock, NanosecondsAreTheNearestSeconds) {
  EXPECT_EQ(secondsOf(1'700'000'000'100'000'000), 1700000000.1);
  EXPECT_EQ(secondsOf(1'700'000'000'033'333'000), 1700000000.033333);
  EXPECT_EQ(secondsOf(1'305'031'102'175'304'321), 1305031102.175304321);
  EXPECT_EQ(secondsOf(-1'500'000'000), -1.5);
}

TEST(StampClock, SaysWhatItCounts) {
  EXPECT_THAT(StampClock(StampUnit::Nanoseconds).sentencePart(), HasSubstr("nanoseconds"));
  EXPECT_THAT(StampClock(StampUnit::Frames, 25.0).sentencePart(), HasSubstr("25 a second"));
}

}  // namespace
}  // namespace wardslam::core
