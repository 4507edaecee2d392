#include "places/floor_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace wardslam::synth {
namespace {

Eigen::AlignedBox2f footprintOf(const Thing& thing, float below_m) {
  Eigen::AlignedBox2f box;
  for (const Surface& surface : thing.surfaces) {
    for (const Vertex& vertex : surface.mesh.vertices) {
      if (vertex.p_m.z() < below_m) box.extend(vertex.p_m.head<2>());
    }
  }
  return box;
}

TEST(FloorPath, IsARoundOfMoreThanFortyMetres) {
  const FloorPath path;
  EXPECT_GT(path.route.length_m(), 40.0);
  EXPECT_NEAR(path.route.length_m() / path.round_s, 0.7, 0.05) << "a robot's speed, m/s";
  EXPECT_TRUE(path.T_world_cam(0.0).isApprox(path.T_world_cam(path.round_s), 1e-6));
}

TEST(FloorPath, IsSmooth) {
  const FloorPath path;
  constexpr double kStep_s = 1.0 / 30;
  for (double t = 0; t < path.round_s; t += kStep_s) {
    const Eigen::Isometry3d step = path.T_world_cam(t).inverse() * path.T_world_cam(t + kStep_s);
    EXPECT_LT(step.translation().norm() / kStep_s, 0.85);
    EXPECT_LT(Eigen::AngleAxisd(step.linear()).angle() / kStep_s, 0.85);
  }
}

TEST(FloorPath, KeepsClearOfTheFurniture) {
  const FloorPath path;
  const Scene scene = buildFloor({1, false});
  for (const Thing& thing : scene.things) {
    if (thing.label.id == 0) continue;
    const Eigen::AlignedBox2f footprint = footprintOf(thing, 1.3F);
    if (footprint.isEmpty()) continue;
    double nearest_m = 100.0;
    for (double t = 0; t < path.round_s; t += 0.1) {
      const Eigen::Vector2f p = path.T_world_cam(t).translation().head<2>().cast<float>();
      nearest_m = std::min(nearest_m, static_cast<double>(footprint.exteriorDistance(p)));
    }
    EXPECT_GT(nearest_m, 0.4) << thing.label.name;
  }
}

TEST(FloorPath, GoesThroughDoorsNotWalls) {
  const FloorPath path;
  bool wasInCorridor = true;
  bool wasWest = true;
  int doors = 0;
  for (double t = 0; t < path.round_s; t += 0.02) {
    const Eigen::Vector3d p = path.T_world_cam(t).translation();
    const bool inCorridor = p.y() < 3.0;
    const bool isWest = p.x() < 9.0;
    if (inCorridor != wasInCorridor) {
      EXPECT_LT(std::min(std::abs(p.x() - 2.0), std::abs(p.x() - 16.0)), 0.3) << p.transpose();
      ++doors;
    }
    if (isWest != wasWest && !inCorridor) {
      EXPECT_NEAR(p.y(), 4.4, 0.3);
      ++doors;
    }
    wasInCorridor = inCorridor;
    wasWest = isWest;
  }
  EXPECT_EQ(doors, 3);
}

TEST(FloorWays, NobodyRunsIntoTheCamera) {
  const FloorPath path;
  const PeopleWays ways = floorWays();
  for (const Walker& walker : {ways.nurse, ways.porter, ways.visitor}) {
    double nearest_m = 100.0;
    for (double t = 0; t < 2 * path.round_s; t += 0.05) {
      nearest_m = std::min(nearest_m, (walker.at(t).p_m - path.T_world_cam(t).translation().head<2>()).norm());
    }
    EXPECT_GT(nearest_m, 0.55);
    EXPECT_LT(nearest_m, 3.0) << "everybody meets the robot";
  }
}

TEST(FloorScene, HasPeopleOnlyWhenAskedTo) {
  EXPECT_EQ(buildFloor({1, true}).actors.size(), 3U);
  EXPECT_TRUE(buildFloor({1, false}).actors.empty());
}

TEST(FloorScene, HasTexturesForAllItsSurfaces) {
  const Scene scene = buildFloor({2, true});
  for (const Thing& thing : scene.things) {
    for (const Surface& surface : thing.surfaces) EXPECT_EQ(scene.textures.count(surface.material), 1U);
  }
}

}  // namespace
}  // namespace wardslam::synth
