#include "synthesis/synthesis.h"

#include <gtest/gtest.h>

namespace wardslam::synth {
namespace {

TEST(SynthesisTest, StampsAreOfTheDayAndOfTheRobotsHour) {
  PlaceOptions place;
  EXPECT_EQ(firstStamp_s(place), 1700000000.0);
  place.hospital.day = 2;
  EXPECT_EQ(firstStamp_s(place), 1700172800.0);
  place.hospital.route.robot = 3;
  EXPECT_EQ(firstStamp_s(place), 1700183600.0);
}

}  // namespace
}  // namespace wardslam::synth
