#include "object_shape.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wardslam::mapping {
namespace {

/// The surface of a block of 2 m by 1 m by 0.5 m on the floor round (3, 4), turned by `yaw_rad`.
std::vector<Eigen::Vector3f> block(float yaw_rad) {
  const Eigen::AngleAxisf turn(yaw_rad, Eigen::Vector3f::UnitZ());
  std::vector<Eigen::Vector3f> points;
  for (float x = -1.0F; x <= 1.001F; x += 0.05F) {
    for (float y = -0.5F; y <= 0.501F; y += 0.05F) {
      for (float z = 0.0F; z <= 0.501F; z += 0.05F) points.push_back(turn * Eigen::Vector3f(x, y, z));
    }
  }
  for (auto& p : points) p += Eigen::Vector3f(3, 4, 0);
  return points;
}

TEST(ObjectShapeTest, BoxesOfABlock) {
  const ObjectShape shape = shapeOf(block(0.0F), 0.15);
  EXPECT_TRUE(shape.centroid_m.isApprox(Eigen::Vector3d(3, 4, 0.25), 1e-3));
  EXPECT_TRUE(shape.box_m.min().isApprox(Eigen::Vector3d(2, 3.5, 0), 1e-3));
  EXPECT_TRUE(shape.box_m.max().isApprox(Eigen::Vector3d(4, 4.5, 0.5), 1e-3));
}

TEST(ObjectShapeTest, TheOrientedBoxTurnsWithTheThing) {
  const ObjectShape shape = shapeOf(block(0.5F), 0.15);
  EXPECT_NEAR(shape.orientedBox.size_m.x(), 2.0, 0.02);
  EXPECT_NEAR(shape.orientedBox.size_m.y(), 1.0, 0.02);
  EXPECT_NEAR(shape.orientedBox.size_m.z(), 0.5, 0.02);
  EXPECT_TRUE(shape.orientedBox.T_map_box.translation().isApprox(Eigen::Vector3d(3, 4, 0.25), 1e-2));
  const Eigen::Vector3d longSide = shape.orientedBox.T_map_box.linear().col(0);
  EXPECT_NEAR(std::remainder(std::atan2(longSide.y(), longSide.x()) - 0.5, M_PI), 0.0, 0.01);
  EXPECT_NEAR(shape.box_m.sizes().x(), 2.0 * std::cos(0.5) + 1.0 * std::sin(0.5), 0.12);  // corners are trimmed
}

TEST(ObjectShapeTest, StrayPointsDoNotCount) {
  auto points = block(0.0F);
  points.emplace_back(3.0F, 4.0F, 2.0F);  // alone in the air
  for (int i = 0; i < 10; ++i) points.emplace_back(4.1F + 0.01F * static_cast<float>(i), 4.0F, 0.2F);  // and a spike
  const ObjectShape shape = shapeOf(points, 0.15);
  EXPECT_NEAR(shape.box_m.max().x(), 4.0, 1e-3);
  EXPECT_NEAR(shape.box_m.max().z(), 0.5, 1e-3);
}

TEST(ObjectShapeTest, PartsOfOneThingThatLieApartCount) {
  auto points = block(0.0F);
  for (Eigen::Vector3f p : block(0.0F)) points.emplace_back(p + Eigen::Vector3f(2.5F, 0, 0));
  EXPECT_NEAR(shapeOf(points, 0.15).box_m.max().x(), 6.5, 1e-3);
}

TEST(ObjectShapeTest, OnePointIsABoxWithoutSize) {
  const ObjectShape shape = shapeOf({{1, 2, 3}}, 0.15);
  EXPECT_EQ(shape.centroid_m, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(shape.box_m.sizes(), Eigen::Vector3d(0, 0, 0));
}

TEST(ObjectShapeTest, PointsWithoutWidthMakeAFlatBoxAndNoNaN) {
  std::vector<Eigen::Vector3f> line;
  std::vector<Eigen::Vector3f> upright;
  std::vector<Eigen::Vector3f> plane;
  for (int i = 0; i < 50; ++i) {
    const float s = 0.02F * static_cast<float>(i);
    line.emplace_back(s, 2.0F * s, 0.5F);
    upright.emplace_back(1.0F, 2.0F, s);
    for (int j = 0; j < 20; ++j) plane.emplace_back(s, 0.0F, 0.02F * static_cast<float>(j));
  }
  const std::vector<Eigen::Vector3f> three = {{0, 0, 0}, {0.1F, 0, 0}, {0, 0.1F, 0}};
  const std::vector<Eigen::Vector3f> same(30, {1, 2, 3});
  for (const auto& points : {line, upright, plane, three, same}) {
    const ObjectShape shape = shapeOf(points, 0.15);
    EXPECT_TRUE(shape.centroid_m.allFinite());
    EXPECT_TRUE(shape.orientedBox.T_map_box.matrix().allFinite());
    EXPECT_NEAR(shape.orientedBox.T_map_box.linear().determinant(), 1.0, 1e-6);
    EXPECT_TRUE((shape.orientedBox.size_m.array() >= 0.0).all()) << shape.orientedBox.size_m.transpose();
    EXPECT_TRUE((shape.box_m.sizes().array() >= 0.0).all());
  }
  EXPECT_NEAR(shapeOf(line, 0.15).orientedBox.size_m.x(), 0.98 * std::sqrt(5.0), 0.1) << "along the line";
  EXPECT_NEAR(shapeOf(line, 0.15).orientedBox.size_m.y(), 0.0, 1e-3);
}

}  // namespace
}  // namespace wardslam::mapping
