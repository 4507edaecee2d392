#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "gates/figures.h"
#include "gates/floor_fixture.h"
#include "gates/object_truth.h"
#include "integration/cli_test_support.h"

namespace wardslam::gates {
namespace {

using ::testing::IsEmpty;

constexpr double kLeast = 0.9;
constexpr std::size_t kFewest = 20;

evaluation::ObjectEvaluation evaluationOf(const Run& run) {
  const auto result =
      evaluation::evaluateObjects(trueObjects(floorRendering()), foundObjects(floorRendering(), run), kSeenWell);
  std::printf("recall %.3f of %zu, precision %.3f of %zu, centres off by %.3f m (median)\n", result.all.recall(),
              result.all.wanted, result.all.precision(), result.all.found, result.center_m.median);
  return result;
}

std::size_t movedObjects(const Run& run) {
  std::size_t moved = 0;
  const auto objects = nlohmann::json::parse(test::readText(run.out / "objects.json")).at("objects");
  for (const auto& object : objects) moved += object.at("state") == "moved" ? 1U : 0U;
  std::printf("%zu of %zu things are told to have moved\n", moved, objects.size());
  return moved;
}

TEST(ObjectsOfTwoRooms, AreFound) {
  const auto result = evaluationOf(floorRun());
  EXPECT_GE(result.all.recall(), kLeast);
  EXPECT_GE(result.all.precision(), kLeast);
}

IdentityFaults faultsOf(const Run& run) {
  return identityFaults(trueObjects(floorRendering()), foundObjects(floorRendering(), run));
}

TEST(ObjectsOfTwoRooms, AreNotTakenForEachOther) {
  const auto faults = faultsOf(floorRun());
  EXPECT_THAT(faults.oneRecordOfTwoThings, IsEmpty());
  EXPECT_THAT(faults.ofAnotherClass, IsEmpty());
}

/// Nothing moves in this rendering. Whatever "has moved" is one record that was two things, one after the other.
TEST(ObjectsOfTwoRooms, KeepTheirRecords) {
  const auto moved = figuresOf([] { return movedObjects(floorRun()); });
  const auto faults = figuresOf([] { return faultsOf(floorRun()); });
  if (!moved || !faults) GTEST_SKIP() << "there is nothing to judge";
  EXPECT_EQ(*moved, 0U);
  EXPECT_THAT(faults->twoRecordsOfOneThing, IsEmpty());
}

TEST(ObjectsOfTwoRooms, AreFoundWithThreads) {
  const auto result = evaluationOf(floorRunWithThreads());
  EXPECT_GE(result.all.wanted, kFewest);
  EXPECT_GE(result.all.recall(), kLeast);
}

TEST(ObjectsOfTwoRooms, AreComparedAsRendered) {
  const auto result =
      test::runProgram("wardslam", {"eval-objects", (floorRendering().labels() / "objects.csv").string(),
                                    (floorRun().out / "objects.json").string(), "--trajectory",
                                    (floorRun().out / "trajectory.txt").string(), "--ground-truth",
                                    floorRendering().truthFile().string()});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_NE(result.out.find("bed"), std::string::npos) << result.out;
}

}  // namespace
}  // namespace wardslam::gates
