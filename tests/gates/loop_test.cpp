#include <gtest/gtest.h>

#include "gates/agreement.h"
#include "gates/figures.h"
#include "gates/floor_fixture.h"

/// A round that comes back to where it began: the loop moves everything, and everything has to move alike.
namespace wardslam::gates {
namespace {

constexpr double kMost_m = 0.001;

enum class Mode { Deterministic, Threads };

class Loop : public ::testing::TestWithParam<Mode> {};

Disagreement disagreementIn(Mode mode) {
  return disagreementOf(mode == Mode::Deterministic ? floorRun() : floorRunWithThreads());
}

TEST_P(Loop, LeavesThingsInTheirCloud) {
  const Disagreement found = disagreementIn(GetParam());
  EXPECT_GT(found.keyframes, 50U);
  EXPECT_GT(found.cloudPoints, 10000U);
  EXPECT_GT(found.objects, 5U);
  EXPECT_LE(found.objectInFile_m, kMost_m);
}

TEST_P(Loop, MovesAllAsTheTrajectory) {
  const auto found = figuresOf([] { return disagreementIn(GetParam()); });
  if (!found || found->keyframes == 0 || found->objects == 0) GTEST_SKIP() << "there is nothing to compare";
  EXPECT_LE(found->keyframe_m, kMost_m);
  EXPECT_LE(found->cloud_m, kMost_m);
  EXPECT_LE(found->object_m, kMost_m);
}

INSTANTIATE_TEST_SUITE_P(Modes, Loop, ::testing::Values(Mode::Deterministic, Mode::Threads),
                         [](const auto& mode) { return mode.param == Mode::Threads ? "Threads" : "Deterministic"; });

}  // namespace
}  // namespace wardslam::gates
