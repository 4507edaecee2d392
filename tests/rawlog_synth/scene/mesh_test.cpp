#include "scene/mesh.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wardslam::synth {
namespace {

float areaOf(const Mesh& mesh) {
  float area = 0.0F;
  for (std::size_t i = 0; i + 2 < mesh.vertices.size(); i += 3) {
    const auto& v = mesh.vertices;
    area += (v[i + 1].p_m - v[i].p_m).cross(v[i + 2].p_m - v[i].p_m).norm() / 2;
  }
  return area;
}

TEST(Mesh, ABoxHasTwelveTrianglesOfItsSurface) {
  const Mesh mesh = box({1.0F, 2.0F, 3.0F});
  EXPECT_EQ(mesh.vertices.size(), 36U);
  EXPECT_NEAR(areaOf(mesh), 22.0F, 1e-4F);
  for (const Vertex& vertex : mesh.vertices) EXPECT_GT(vertex.normal.dot(vertex.p_m), 0.0F);
}

TEST(Mesh, AnEllipsoidLiesOnItsSurfaceWithNormalsOutwards) {
  const Eigen::Vector3f radii(0.3F, 0.2F, 0.5F);
  for (const Vertex& vertex : ellipsoid(radii, 24, 32).vertices) {
    EXPECT_NEAR(vertex.p_m.cwiseQuotient(radii).norm(), 1.0F, 1e-4F);
    EXPECT_GT(vertex.normal.dot(vertex.p_m), 0.0F);
    EXPECT_NEAR(vertex.normal.norm(), 1.0F, 1e-4F);
  }
  EXPECT_NEAR(areaOf(ellipsoid({1, 1, 1}, 48, 64)), 4 * static_cast<float>(M_PI), 0.05F);
}

TEST(Mesh, ARodLeadsFromAToB) {
  const Eigen::Vector3f a(1, 2, 3);
  const Eigen::Vector3f b(2, 0, 1);
  const Mesh mesh = rod(a, b, 0.1F, 0.1F, 32);
  const float pi = static_cast<float>(M_PI);
  EXPECT_NEAR(areaOf(mesh), 2 * pi * 0.1F * 3.0F + 2 * pi * 0.01F, 0.02F);
  for (const Vertex& vertex : mesh.vertices) {
    const float along = (vertex.p_m - a).dot((b - a).normalized());
    EXPECT_GT(along, -1e-4F);
    EXPECT_LT(along, 3.0F + 1e-4F);
  }
}

TEST(Mesh, APanelShowsTheTextureUpright) {
  const Mesh mesh = panel({0, 0, 0}, {2, 0, 0}, {0, 0, 1});
  for (const Vertex& vertex : mesh.vertices) {
    EXPECT_NEAR(vertex.uv.x(), vertex.p_m.x() / 2, 1e-6F);
    EXPECT_NEAR(vertex.uv.y(), 1 - vertex.p_m.z(), 1e-6F);
    EXPECT_TRUE(vertex.normal.isApprox(-Eigen::Vector3f::UnitY()));
  }
}

TEST(Mesh, ADrapeHangsFromItsRail) {
  const Mesh mesh = drape({0, 0, 2}, {1, 0, 2}, 1.5F, 0.2F, 0.05F);
  for (const Vertex& vertex : mesh.vertices) {
    EXPECT_TRUE(std::abs(vertex.p_m.z() - 2.0F) < 1e-5F || std::abs(vertex.p_m.z() - 0.5F) < 1e-5F);
    EXPECT_LE(std::abs(vertex.p_m.y()), 0.05F + 1e-5F);
  }
}

TEST(Mesh, TransformMovesPointsAndTurnsNormals) {
  Mesh mesh = panel({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  mesh.transform(at(1, 2, 3, static_cast<float>(M_PI) / 2));
  EXPECT_TRUE(mesh.vertices[1].p_m.isApprox(Eigen::Vector3f(1, 3, 3), 1e-5F));
  EXPECT_TRUE(mesh.vertices[1].normal.isApprox(Eigen::Vector3f::UnitZ(), 1e-5F));
}

}  // namespace
}  // namespace wardslam::synth
