#include "chunks.h"

#include <gtest/gtest.h>

#include "camera_options.h"
#include "camera_path.h"
#include "ward_scene.h"

namespace wardslam::synth {
namespace {

Eigen::AlignedBox3f cube(float x, float y, float z, float half_m = 0.5F) {
  const Eigen::Vector3f middle(x, y, z);
  return {middle - Eigen::Vector3f::Constant(half_m), middle + Eigen::Vector3f::Constant(half_m)};
}

TEST(Frustum, ShowsWhatLiesBetweenItsEdges) {
  // At the origin, optical axis along z; half the image is 319.5 / 525 of the depth.
  const Frustum frustum(cameraFor(640, 480), Eigen::Isometry3d::Identity(), 30.0);
  EXPECT_TRUE(frustum.mayShow(cube(0, 0, 5)));
  EXPECT_TRUE(frustum.mayShow(cube(0, 0, 0))) << "around the camera";
  EXPECT_FALSE(frustum.mayShow(cube(0, 0, -5)));
  EXPECT_FALSE(frustum.mayShow(cube(0, 0, 35)));
  EXPECT_TRUE(frustum.mayShow(cube(3.7F, 0, 5))) << "its corner lies at 3.2 m, the edge of the image at 3.35 m";
  EXPECT_FALSE(frustum.mayShow(cube(4.0F, 0, 5)));
  EXPECT_FALSE(frustum.mayShow(cube(0, -3.2F, 5)));
  EXPECT_TRUE(frustum.mayShow(cube(0, 0, 5, 100)));
}

TEST(Chunks, HoldEveryTriangleOnceAndInOrder) {
  const Scene scene = buildWard({});
  std::size_t triangles = 0;
  for (const Thing& thing : scene.things) {
    for (const Surface& surface : thing.surfaces) triangles += surface.mesh.vertices.size() / 3;
  }
  std::size_t next = 0;
  const Chunks chunks(scene);
  for (const Chunks::Run& run : chunks.runs()) {
    EXPECT_EQ(run.firstNumber, next);
    next += run.triangles;
  }
  EXPECT_EQ(next, triangles);
}

TEST(Chunks, WhatProjectsIntoTheImageIsSeenAndMuchElseIsNot) {
  const Scene scene = buildWard({});
  const Chunks chunks(scene);
  const core::CameraModel camera = cameraFor(320, 240);
  const CameraPath path;
  for (const double t_s : {0.0, 7.0, 19.0, 31.0}) {
    const Eigen::Isometry3d T_world_cam = path.T_world_cam(t_s);
    const auto seen = chunks.seenFrom(T_world_cam, Frustum(camera, T_world_cam, 30.0));
    std::size_t left = 0;
    for (const Chunks::Run& run : chunks.runs()) {
      left += seen[run.chunk] ? 0 : run.triangles;
      for (std::size_t i = 0; i < 3 * run.triangles; ++i) {
        const Eigen::Vector3d p_cam = T_world_cam.inverse() * run.vertices[i].p_m.cast<double>();
        if (p_cam.z() < 0.1) continue;
        const Eigen::Vector2d pixel = camera.project(p_cam);
        const bool isInImage = pixel.minCoeff() >= 0 && pixel.x() <= 319 && pixel.y() <= 239;
        ASSERT_TRUE(seen[run.chunk] || !isInImage);
      }
    }
    EXPECT_GT(left, 1000U) << "at " << t_s;
  }
}

TEST(Chunks, CellsThatAPlaceHidesAreNotSeen) {
  Scene scene;
  const Surfaces wall = {{Material::Linen, panel({2, 1, 0}, {0, -1, 0}, {0, 0, 1})}};
  scene.things.push_back({{1, "here", 0, ""}, wall, 1});
  scene.things.push_back({{2, "behind the door", 0, ""}, wall, 2});
  scene.mayBeSeen = [](int cell, const Eigen::Isometry3d& /*T_world_cam*/) { return cell == 1; };
  const Chunks chunks(scene);
  Eigen::Isometry3d T_world_cam = Eigen::Isometry3d::Identity();
  T_world_cam.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;  // looks along x
  const auto seen = chunks.seenFrom(T_world_cam, Frustum(cameraFor(320, 240), T_world_cam, 30.0));
  ASSERT_EQ(chunks.runs().size(), 2U);
  EXPECT_TRUE(seen[chunks.runs()[0].chunk]);
  EXPECT_FALSE(seen[chunks.runs()[1].chunk]);
}

TEST(CellView, HidesWhatLiesInUnseenPartsAlone) {
  Scene scene;
  const Mesh cube = box({4, 4, 2});
  scene.things.push_back({{1, "here", 1, "box"}, {{Material::Plastic, cube}}, 0});
  Mesh there = cube;
  scene.things.push_back({{2, "there", 1, "box"}, {{Material::Plastic, there.transform(at(4, 0, 0))}}, 1});
  scene.mayBeSeen = [](int cell, const Eigen::Isometry3d&) { return cell == 0; };
  const Chunks chunks(scene);
  const CellView cells = chunks.cellsFrom(Eigen::Isometry3d::Identity());
  const auto boxAround = [](float x_m) {
    return Eigen::AlignedBox3f(Eigen::Vector3f(x_m - 0.5F, -0.5F, 0), Eigen::Vector3f(x_m + 0.5F, 0.5F, 1));
  };
  EXPECT_TRUE(cells.mayShow(boxAround(0)));
  EXPECT_TRUE(cells.mayShow(boxAround(2))) << "in the door";
  EXPECT_FALSE(cells.mayShow(boxAround(4)));
  EXPECT_TRUE(cells.mayShow(boxAround(9))) << "nobody knows what is there";
  scene.mayBeSeen = [](int cell, const Eigen::Isometry3d&) { return cell == 1; };
  const CellView others = chunks.cellsFrom(Eigen::Isometry3d::Identity());
  EXPECT_TRUE(others.mayShow(boxAround(2))) << "in the door, seen from the other side";
  EXPECT_FALSE(others.mayShow(boxAround(0)));
  scene.mayBeSeen = nullptr;
  EXPECT_TRUE(chunks.cellsFrom(Eigen::Isometry3d::Identity()).mayShow(boxAround(4)));
}

}  // namespace
}  // namespace wardslam::synth
