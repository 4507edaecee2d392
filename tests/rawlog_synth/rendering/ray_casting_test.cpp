#include "rendering/ray_casting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <thread>

namespace wardslam::synth {
namespace {

/// 7 x 5 rays ahead, along z but for the tenth of a metre a metre from pixel to pixel; (3, 2) is the middle one.
RayFan someRays() {
  RayFan fan;
  fan.directions = {cv::Mat(5, 7, CV_32FC1), cv::Mat(5, 7, CV_32FC1)};
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 7; ++x) {
      fan.directions.x.at<float>(y, x) = 0.1F * static_cast<float>(x - 3);
      fan.directions.y.at<float>(y, x) = 0.1F * static_cast<float>(y - 2);
    }
  }
  fan.nearest_m = 0.2F;
  fan.farthest_m = 20.0F;
  return fan;
}

/// Covers all rays at that depth.
Mesh wallAt(float z_m) { return panel({-9, -9, z_m}, {18, 0, 0}, {0, 18, 0}); }

Piece pieceOf(const Mesh& mesh, std::uint16_t id) {
  return {mesh.vertices.data(), mesh.vertices.size() / 3, Material::Linen, id};
}

/// Pixels by what they show; 0 = nothing.
std::map<int, int> pixelsOf(const RayFan& fan, const std::vector<std::shared_ptr<const RayCaster::Tree>>& trees) {
  std::map<int, int> count;
  castRays(fan, trees, [&](int, int, const Hit& hit) {
    ++count[hit.piece == nullptr ? 0 : static_cast<int>(hit.piece->instanceId)];
  });
  return count;
}

TEST(RayCasting, MeetsTheNearestOfAnyTree) {
  const RayCaster caster;
  const Mesh near = wallAt(2);
  const Mesh far = wallAt(4);
  const Mesh farther = wallAt(6);
  const auto first = caster.plant({pieceOf(farther, 3), pieceOf(far, 2)}, RayCaster::Use::Often);
  const auto second = caster.plant({pieceOf(near, 1)}, RayCaster::Use::Once);
  using Count = std::map<int, int>;
  EXPECT_EQ(pixelsOf(someRays(), {first}), (Count{{2, 35}}));
  EXPECT_EQ(pixelsOf(someRays(), {first, second}), (Count{{1, 35}}));
  EXPECT_EQ(pixelsOf(someRays(), {second, first}), (Count{{1, 35}}));
  EXPECT_EQ(pixelsOf(someRays(), {}), (Count{{0, 35}}));
}

TEST(RayCasting, SeesNothingNearerOrFartherThanAsked) {
  const RayCaster caster;
  const Mesh wall = wallAt(2);
  const auto tree = caster.plant({pieceOf(wall, 1)}, RayCaster::Use::Often);
  RayFan fan = someRays();
  fan.farthest_m = 1.9F;
  EXPECT_EQ(pixelsOf(fan, {tree}).count(1), 0U);
  fan.farthest_m = 20.0F;
  fan.nearest_m = 2.1F;
  EXPECT_EQ(pixelsOf(fan, {tree}).count(1), 0U);
}

TEST(RayCasting, SaysWhereOnTheTriangle) {
  const RayCaster caster;
  const Mesh wall = wallAt(4);
  const auto tree = caster.plant({pieceOf(wall, 1)}, RayCaster::Use::Often);
  RayFan fan = someRays();
  fan.T_world_cam.translation() = Eigen::Vector3d(0.5, -0.25, 1);
  int visited = 0;
  castRays(fan, {tree}, [&](int x, int y, const Hit& hit) {
    ++visited;
    ASSERT_NE(hit.piece, nullptr);
    const Eigen::Vector3f p =
        (1 - hit.u - hit.v) * hit.corners[0].p_m + hit.u * hit.corners[1].p_m + hit.v * hit.corners[2].p_m;
    const Eigen::Vector3f expected(0.5F + 0.3F * static_cast<float>(x - 3), -0.25F + 0.3F * static_cast<float>(y - 2),
                                   4);
    EXPECT_LT((p - expected).norm(), 1e-4F) << x << ", " << y;
    EXPECT_NEAR(hit.depth_m, 3.0F, 1e-5F);
  });
  EXPECT_EQ(visited, 35);
}

TEST(RayCasting, NoRaySlipsThroughWhereTrianglesMeet) {
  // A closed sphere around the camera, seen along rays that meet its edges and corners.
  const RayCaster caster;
  const Mesh sphere = ellipsoid({3, 3, 3}, 24, 48);
  const auto tree = caster.plant({pieceOf(sphere, 1)}, RayCaster::Use::Often);
  RayFan fan = someRays();
  const auto columns = static_cast<int>(sphere.vertices.size());
  fan.directions = {cv::Mat(1, columns, CV_32FC1), cv::Mat(1, columns, CV_32FC1)};
  for (int i = 0; i < columns; ++i) {
    const Vertex* corner = &sphere.vertices[static_cast<std::size_t>(i / 3 * 3)];
    const float share = i % 3 == 0 ? 0.0F : 0.37F * static_cast<float>(i % 3);
    const Eigen::Vector3f p = corner[0].p_m + share * (corner[1].p_m - corner[0].p_m);
    const float ahead = std::max(p.z(), 0.1F);
    fan.directions.x.at<float>(0, i) = p.x() / ahead;
    fan.directions.y.at<float>(0, i) = p.y() / ahead;
  }
  fan.nearest_m = 0.0F;
  EXPECT_EQ(pixelsOf(fan, {tree}).count(0), 0U);
}

TEST(RayCasting, ThreadsMayPlantAndLookAtOnce) {
  const RayCaster caster;
  const Mesh wall = wallAt(4);
  const auto things = caster.plant({pieceOf(wall, 1)}, RayCaster::Use::Often);
  std::vector<std::thread> threads;
  std::vector<int> right(4, 0);
  for (std::size_t thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&, thread] {
      for (int i = 0; i < 50; ++i) {
        const Mesh ball = ellipsoid({0.5F, 0.5F, 0.5F});
        Mesh ahead = ball;
        ahead.transform(at(0, 0, 2));
        const auto actors = caster.plant({pieceOf(ahead, 2)}, RayCaster::Use::Once);
        const auto count = pixelsOf(someRays(), {things, actors});
        if (count.at(1) + count.at(2) == 35 && count.at(2) > 5) ++right[thread];
      }
    });
  }
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(right, std::vector<int>(4, 50));
}

}  // namespace
}  // namespace wardslam::synth
