#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <opencv2/core.hpp>

#include "gates/floor_fixture.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::gates {
namespace {

struct Content {
  std::size_t keyframes = 0;
  std::size_t fans = 0;
  std::size_t objects = 0;
  double free_m2 = 0.0;
};

Content contentOf(const Run& run) {
  const auto map = storage::MapFile::open(run.map()).read(storage::CloudPart::LeaveOut);
  Content content;
  content.keyframes = map.keyframes.size();
  for (const auto& [id, keyframe] : map.keyframes) content.fans += keyframe.freeFan_cam_m.empty() ? 0U : 1U;
  content.objects = map.objects.size();
  const double cell_m = map.floorPlan.resolution_m;
  content.free_m2 = cell_m * cell_m * cv::countNonZero(map.floorPlan.cells == mapping::FloorPlan::kFree);
  std::printf("%zu keyframes, %zu fans, %zu things, %.1f m2 of free floor\n", content.keyframes, content.fans,
              content.objects, content.free_m2);
  return content;
}

/// Of figures that should be the same but for what threads leave to chance.
void expectWithin(double share, double value, double reference, const char* what) {
  EXPECT_LE(std::abs(value - reference), share * reference) << what << ": " << value << ", not " << reference;
}

constexpr double kShare = 0.03;

std::size_t viewsWorkedIn(const Run& run) { return run.summary().at("stages").at("mapping.add").at("calls"); }

/// A recording waits for the mapper, on a busy machine, too.
TEST(DefaultRun, MakesTheMapOfADeterministicOne) {
  const Content wanted = contentOf(floorRun());
  const Content found = contentOf(floorRunWithThreads());
  EXPECT_EQ(found.fans, found.keyframes);
  EXPECT_EQ(viewsWorkedIn(floorRunWithThreads()), viewsWorkedIn(floorRun()));
  expectWithin(kShare, static_cast<double>(found.objects), static_cast<double>(wanted.objects), "things");
  const nlohmann::json events = floorRunWithThreads().summary().at("events");
  for (const auto& [event, count] : events.items()) {
    EXPECT_NE(event.rfind("mapping.", 0), 0U) << event << ": " << count;
    EXPECT_NE(event.rfind("storage.", 0), 0U) << event << ": " << count;
  }
}

/// Where the graph lags behind, tracking learns late of known places, and fewer keyframes are given up.
TEST(DefaultRun, HasTheFloorOfADeterministicOne) {
  const Content wanted = contentOf(floorRun());
  const Content found = contentOf(floorRunWithThreads());
  expectWithin(kShare, static_cast<double>(found.keyframes), static_cast<double>(wanted.keyframes), "keyframes");
  expectWithin(kShare, found.free_m2, wanted.free_m2, "free floor");
}

/// A camera does not wait; views of keyframes are worked in, and what is left out is counted.
TEST(DefaultRun, InRealTimeLeavesOutNoKeyframeAndCountsTheRest) {
  const Content found = contentOf(floorRunInRealTime());
  const auto summary = floorRunInRealTime().summary();
  EXPECT_EQ(found.fans, found.keyframes);
  const std::size_t leftOut = summary.at("events").value("mapping.view_left_out", std::size_t{0});
  const std::size_t views = viewsWorkedIn(floorRun());
  const std::size_t workedIn = viewsWorkedIn(floorRunInRealTime());
  std::printf("%zu views worked in, %zu left out; %zu in a run that waits\n", workedIn, leftOut, views);
  expectWithin(kShare, static_cast<double>(workedIn + leftOut), static_cast<double>(views), "views");
}

}  // namespace
}  // namespace wardslam::gates
