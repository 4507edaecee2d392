#include "rendering/in_view.h"

#include <gtest/gtest.h>

#include "camera/camera_options.h"

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

TEST(CellView, HidesWhatLiesInUnseenPartsAlone) {
  Scene scene;
  const Mesh cube = box({4, 4, 2});
  scene.things.push_back({{1, "here", 1, "box"}, {{Material::Plastic, cube}}, 0});
  Mesh there = cube;
  scene.things.push_back({{2, "there", 1, "box"}, {{Material::Plastic, there.transform(at(4, 0, 0))}}, 1});
  scene.mayBeSeen = [](int cell, const Eigen::Isometry3d&) { return cell == 0; };
  const Cells parts(scene);
  const CellView cells = parts.seenFrom(Eigen::Isometry3d::Identity());
  const auto boxAround = [](float x_m) {
    return Eigen::AlignedBox3f(Eigen::Vector3f(x_m - 0.5F, -0.5F, 0), Eigen::Vector3f(x_m + 0.5F, 0.5F, 1));
  };
  EXPECT_TRUE(cells.mayShow(boxAround(0)));
  EXPECT_TRUE(cells.mayShow(boxAround(2))) << "in the door";
  EXPECT_FALSE(cells.mayShow(boxAround(4)));
  EXPECT_TRUE(cells.mayShow(boxAround(9))) << "nobody knows what is there";
  scene.mayBeSeen = [](int cell, const Eigen::Isometry3d&) { return cell == 1; };
  const CellView others = parts.seenFrom(Eigen::Isometry3d::Identity());
  EXPECT_TRUE(others.mayShow(boxAround(2))) << "in the door, seen from the other side";
  EXPECT_FALSE(others.mayShow(boxAround(0)));
  scene.mayBeSeen = nullptr;
  EXPECT_TRUE(parts.seenFrom(Eigen::Isometry3d::Identity()).mayShow(boxAround(4)));
}

}  // namespace
}  // namespace wardslam::synth
