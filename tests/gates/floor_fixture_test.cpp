#include "gates/floor_fixture.h"

#include <gtest/gtest.h>

#include <fstream>
#include <future>
#include <string>
#include <vector>

#include "gates/agreement.h"

namespace wardslam::gates {
namespace fs = std::filesystem;

fs::path floorFolder() { return fs::path(WARDSLAM_GATES_DIR) / "floor"; }

namespace {

constexpr std::size_t kImages = 330;

/// What has to be so for the figures of the gates to mean something.
void expectWholeRoundWithLoop(const Run& run) {
  EXPECT_EQ(run.summary().at("frames_tracked"), kImages);
  EXPECT_EQ(run.summary().at("lost_events"), 0);
  EXPECT_GE(run.summary().at("loops_closed"), 1);
  EXPECT_LT(ate_m(floorRendering(), run), 0.05);
  EXPECT_TRUE(fs::exists(run.map()));
}

std::vector<std::string> arguments() {
  const fs::path configuration = floorFolder() / "small.yaml";
  std::ofstream(configuration) << "features: {key_points: 700}\n" << kWholeCloud;
  return {"--config", configuration.string(), "--masks", floorRendering().masks().string()};
}

TEST(FloorFixture, IsRendered) {
  fs::remove_all(floorFolder());
  fs::create_directories(floorFolder());
  // 6 s longer than a round, so that the map grows on after its loop is closed.
  render(floorFolder() / "floor.rawlog", {"--scene", "floor", "--no-people", "--rate", "5", "--seconds", "66"});
  EXPECT_EQ(floorRendering().truth().size(), kImages);
}

TEST(FloorFixture, IsRunDeterministically) {
  auto all = arguments();
  all.emplace_back("--deterministic");
  fs::remove_all(floorRun().out);
  run(floorRendering(), floorRun().out, all);
  expectWholeRoundWithLoop(floorRun());
}

/// Two runs beside each other on one core, one of them as images come from a camera.
TEST(FloorFixture, IsRunWithThreads) {
  const OneCore busy;
  fs::remove_all(floorRunWithThreads().out);
  fs::remove_all(floorRunInRealTime().out);
  auto inRealTime = arguments();
  inRealTime.emplace_back("--realtime");
  auto beside = std::async(std::launch::async, [&] { run(floorRendering(), floorRunInRealTime().out, inRealTime); });
  run(floorRendering(), floorRunWithThreads().out, arguments());
  beside.get();
  expectWholeRoundWithLoop(floorRunWithThreads());
}

TEST(FloorFixture, IsRemoved) { EXPECT_GT(fs::remove_all(floorFolder()), 0U); }

}  // namespace
}  // namespace wardslam::gates
