#include "stretches.h"

#include <gmock/gmock.h>

namespace wardslam::report {
namespace {

using odometry::State;
using pipeline::FrameRow;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// A frame a second, from 100 s on.
std::vector<FrameRow> framesOf(const std::vector<std::pair<State, std::uint32_t>>& states) {
  std::vector<FrameRow> frames;
  for (const auto& [state, piece] : states) {
    FrameRow frame;
    frame.stamp_s = 100.0 + static_cast<double>(frames.size());
    frame.state = state;
    frame.piece = piece;
    frames.push_back(frame);
  }
  return frames;
}

TEST(Stretches, NothingIsLostWhereEveryFrameHasAPose) {
  EXPECT_THAT(stretchesWithoutPose({}), IsEmpty());
  EXPECT_THAT(stretchesWithoutPose(framesOf({{State::Ok, 0}, {State::Ok, 0}})), IsEmpty());
}

TEST(Stretches, TellHowEachEnded) {
  const auto found = stretchesWithoutPose(framesOf({{State::Initialising, 0},  // 100
                                                    {State::Ok, 0},
                                                    {State::Lost, 0},  // 102
                                                    {State::Lost, 0},
                                                    {State::Ok, 0},  // 104
                                                    {State::Lost, 0},
                                                    {State::Initialising, 1},
                                                    {State::Ok, 1},  // 107
                                                    {State::Lost, 1}}));
  ASSERT_THAT(found, SizeIs(4));
  const auto expect = [&](std::size_t i, double from_s, double to_s, std::size_t frames, Ending ending) {
    EXPECT_EQ(found[i].from_s, from_s) << i;
    EXPECT_EQ(found[i].to_s, to_s) << i;
    EXPECT_EQ(found[i].frames, frames) << i;
    EXPECT_EQ(found[i].ending, ending) << i;
  };
  expect(0, 100.0, 101.0, 1, Ending::Begins);
  expect(1, 102.0, 104.0, 2, Ending::Found);
  expect(2, 105.0, 107.0, 2, Ending::BegunAnew);
  expect(3, 108.0, 108.0, 1, Ending::NotAnymore);
}

}  // namespace
}  // namespace wardslam::report
