#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "gates/floor_fixture.h"
#include "wardslam/storage/map_file.h"

/// Ten runs that go on in one map, each over the first two seconds of the round only. What they do not see, more than
/// half of that floor, stays in the file as the first run left it.
namespace wardslam::gates {
namespace {

namespace fs = std::filesystem;
using mapping::SemanticMap;

constexpr int kImages = 10;
constexpr double kSight_m = 8.0;  // depth beyond 6 m is not used; in the corners of the image that is 7.6 m away
constexpr std::size_t kFewest = 30;

enum class Mode { Deterministic, Threads };

class GoingOn : public ::testing::TestWithParam<Mode> {
 protected:
  GoingOn() {
    fs::create_directories(folder_);
    fs::copy_file(floorRun().map(), grown_, fs::copy_options::overwrite_existing);
  }

  [[nodiscard]] core::Trajectory goOn() const {
    std::vector<std::string> arguments = {"--map",        grown_.string(),
                                          "--masks",      floorRendering().masks().string(),
                                          "--config",     (floorFolder() / "small.yaml").string(),
                                          "--max-frames", std::to_string(kImages)};
    if (GetParam() == Mode::Deterministic) arguments.emplace_back("--deterministic");
    return run(floorRendering(), folder_ / "run", arguments).trajectory();
  }

  const fs::path folder_ = floorFolder() / (GetParam() == Mode::Threads ? "going_on_threads" : "going_on");
  const fs::path grown_ = folder_ / "floor.wardmap";
};

bool isOutOfSight(const Eigen::AlignedBox3d& box_m, const core::Trajectory& way) {
  return std::all_of(way.begin(), way.end(), [&box_m](const auto& pose) {
    return box_m.exteriorDistance(Eigen::Vector3d(pose.T_map_cam.translation())) > kSight_m;
  });
}

int viewsOfThings(const SemanticMap& map) {
  return std::accumulate(map.objects.begin(), map.objects.end(), 0,
                         [](int sum, const auto& object) { return sum + object.second.views; });
}

void expectEqual(const mapping::MapObject& is, const mapping::MapObject& was) {
  EXPECT_EQ(is.centroid_m, was.centroid_m) << was.id;
  EXPECT_EQ(is.box_m.min(), was.box_m.min()) << was.id;
  EXPECT_EQ(is.box_m.max(), was.box_m.max()) << was.id;
  EXPECT_EQ(is.orientedBox.T_map_box.matrix(), was.orientedBox.T_map_box.matrix()) << was.id;
  EXPECT_EQ(is.orientedBox.size_m, was.orientedBox.size_m) << was.id;
  EXPECT_EQ(is.classId, was.classId) << was.id;
  EXPECT_EQ(is.state, was.state) << was.id;
  EXPECT_EQ(is.probability, was.probability) << was.id;
  EXPECT_EQ(is.views, was.views) << was.id;
}

/// Returns how many things that is.
std::size_t expectThingsOutOfSightAsTheyWere(const SemanticMap& is, const SemanticMap& was,
                                             const core::Trajectory& way) {
  std::size_t things = 0;
  for (const auto& [id, object] : was.objects) {
    if (!isOutOfSight(object.box_m, way)) continue;
    ++things;
    const auto now = is.objects.find(id);
    EXPECT_NE(now, is.objects.end()) << id << " is no more";
    if (now != is.objects.end()) expectEqual(now->second, object);
  }
  return things;
}

/// All that are there still: one that shows what others show may be given up.
std::size_t expectKeyframesWhereTheyWere(const SemanticMap& is, const SemanticMap& was) {
  std::size_t keyframes = 0;
  for (const auto& [id, keyframe] : was.keyframes) {
    const auto now = is.keyframes.find(id);
    if (now == is.keyframes.end()) continue;
    ++keyframes;
    EXPECT_EQ(now->second.T_map_cam.matrix(), keyframe.T_map_cam.matrix()) << id;
  }
  return keyframes;
}

using PointAsSeen = std::tuple<float, float, float, int, std::uint32_t, int>;

std::multiset<PointAsSeen> pointsOutOfSight(const SemanticMap& map, std::uint64_t keyframe,
                                            const core::Trajectory& way) {
  std::multiset<PointAsSeen> points;
  const auto tile = map.cloud.find(keyframe);
  if (tile == map.cloud.end()) return points;
  const Eigen::Isometry3d& T_map_cam = map.keyframes.at(keyframe).T_map_cam;
  for (const auto& point : tile->second.points) {
    const Eigen::Vector3d p_map_m = T_map_cam * point.p_cam_m.cast<double>();
    if (!isOutOfSight({p_map_m, p_map_m}, way)) continue;
    points.emplace(point.p_cam_m.x(), point.p_cam_m.y(), point.p_cam_m.z(), point.classId, point.object,
                   point.sightings);
  }
  return points;
}

std::size_t expectCloudOutOfSightAsItWas(const SemanticMap& is, const SemanticMap& was, const core::Trajectory& way) {
  std::size_t points = 0;
  for (const auto& [keyframe, tile] : was.cloud) {
    if (is.keyframes.count(keyframe) == 0) continue;  // what was given up has an heir
    const auto before = pointsOutOfSight(was, keyframe, way);
    const auto after = pointsOutOfSight(is, keyframe, way);
    EXPECT_TRUE(std::includes(after.begin(), after.end(), before.begin(), before.end())) << keyframe;
    points += before.size();
  }
  return points;
}

TEST_P(GoingOn, TenTimesLeavesWhatNobodyLookedAtAsItWas) {
  const SemanticMap before = storage::MapFile::open(grown_).read();
  int views = viewsOfThings(before);
  for (int i = 0; i < 10; ++i) {
    const core::Trajectory way = goOn();
    ASSERT_EQ(way.size(), static_cast<std::size_t>(kImages)) << "all of them in the map";
    const auto file = storage::MapFile::open(grown_);
    ASSERT_THAT(file.check(), testing::IsEmpty());
    const SemanticMap after = file.read();
    EXPECT_GT(viewsOfThings(after), std::exchange(views, viewsOfThings(after))) << "things in sight were looked at";
    const std::size_t keyframes = expectKeyframesWhereTheyWere(after, before);
    const std::size_t things = expectThingsOutOfSightAsTheyWere(after, before, way);
    const std::size_t points = expectCloudOutOfSightAsItWas(after, before, way);
    std::printf("run %d: %zu of %zu keyframes, %zu of %zu things and %zu points out of sight; %zu keyframes now\n", i,
                keyframes, before.keyframes.size(), things, before.objects.size(), points, after.keyframes.size());
    EXPECT_GE(things, kFewest);
    EXPECT_GE(keyframes, before.keyframes.size() * 9 / 10);
    EXPECT_GE(points, 10000U);
    if (HasFailure()) FAIL() << "in run " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, GoingOn, ::testing::Values(Mode::Deterministic, Mode::Threads),
                         [](const auto& mode) { return mode.param == Mode::Threads ? "Threads" : "Deterministic"; });

}  // namespace
}  // namespace wardslam::gates
