#include <gtest/gtest.h>

#include "gates/agreement.h"
#include "gates/floor_fixture.h"

/// A round that comes back to where it began: the loop moves everything, and everything has to move alike.
namespace wardslam::gates {
namespace {

constexpr double kMost_m = 0.001;
constexpr double kSame_m = 1e-6;
constexpr double kSameInSinglePrecision_m = 1e-5;

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
  const Disagreement found = disagreementIn(GetParam());
  ASSERT_GT(found.keyframes, 50U);
  ASSERT_GT(found.objects, 5U);
  EXPECT_LE(found.keyframe_m, kSame_m);
  EXPECT_LE(found.cloud_m, kSame_m);
  EXPECT_LE(found.object_m, kSameInSinglePrecision_m);
}

TEST_P(Loop, ReachesTheLivePose) {
  const Continuity found =
      continuityOf(floorRendering(), GetParam() == Mode::Threads ? floorRunWithThreads() : floorRun());
  EXPECT_LE(found.step_m, 0.03);
  EXPECT_LE(found.liveInEnd_m, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Modes, Loop, ::testing::Values(Mode::Deterministic, Mode::Threads),
                         [](const auto& mode) { return mode.param == Mode::Threads ? "Threads" : "Deterministic"; });

}  // namespace
}  // namespace wardslam::gates
