#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "gates/floor_fixture.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::gates {
namespace {

namespace fs = std::filesystem;
using mapping::SemanticMap;

constexpr double kOutOfSight_m =
    12.0;  // keyframes 6 m off may see what these runs see, and move; they look 6 m far themselves

/// Farther than the camera of these runs can see: they are the first two seconds of the rendering.
std::vector<mapping::ObjectId> outOfSight(const SemanticMap& map, const core::Trajectory& way) {
  std::vector<mapping::ObjectId> far;
  for (const auto& [id, object] : map.objects) {
    const bool isFar = std::all_of(way.begin(), way.end(), [&centroid_m = object.centroid_m](const auto& pose) {
      return (pose.T_map_cam.translation() - centroid_m).norm() > kOutOfSight_m;
    });
    if (isFar) far.push_back(id);
  }
  return far;
}

void expectEqual(const mapping::MapObject& is, const mapping::MapObject& was) {
  EXPECT_EQ(is.centroid_m, was.centroid_m) << was.id;
  EXPECT_EQ(is.box_m.min(), was.box_m.min()) << was.id;
  EXPECT_EQ(is.box_m.max(), was.box_m.max()) << was.id;
  EXPECT_EQ(is.probability, was.probability) << was.id;
  EXPECT_EQ(is.views, was.views) << was.id;
}

TEST(GoingOn, TenTimesLeavesWhatNobodyLookedAtAsItWas) {
  if (!fs::exists(floorRun().map())) GTEST_SKIP() << "there is nothing to go on in";
  const fs::path folder = floorFolder() / "going_on";
  const fs::path grown = folder / "floor.wardmap";
  fs::create_directories(folder);
  fs::copy_file(floorRun().map(), grown, fs::copy_options::overwrite_existing);
  const SemanticMap before = storage::MapFile::open(grown).read();
  for (int i = 0; i < 10; ++i) {
    const auto again = run(floorRendering(), folder / "run",
                           {"--map", grown.string(), "--masks", floorRendering().masks().string(), "--config",
                            (floorFolder() / "small.yaml").string(), "--max-frames", "10"});
    const auto file = storage::MapFile::open(grown);
    ASSERT_THAT(file.check(), testing::IsEmpty()) << "run " << i;
    const SemanticMap after = file.read();
    const auto far = outOfSight(before, again.trajectory());
    if (i == 0) std::printf("%zu of %zu things are out of sight\n", far.size(), before.objects.size());
    ASSERT_GE(far.size(), 10U);
    for (const mapping::ObjectId id : far) {
      ASSERT_EQ(after.objects.count(id), 1U) << id << ", run " << i;
      expectEqual(after.objects.at(id), before.objects.at(id));
    }
    if (HasFailure()) FAIL() << "run " << i;
  }
}

}  // namespace
}  // namespace wardslam::gates
