#include "scene/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace wardslam::synth {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kTwoPi = 6.28318530718F;

/// Two triangles; none where corners coincide, as at the tip of a loft.
void addQuad(Mesh& mesh, const std::array<Vertex, 4>& corner) {
  const auto same = [&](std::size_t i, std::size_t k) {
    return (corner[i].p_m - corner[k].p_m).squaredNorm() < 1e-12F;
  };
  if (!same(0, 1) && !same(1, 2)) mesh.vertices.insert(mesh.vertices.end(), {corner[0], corner[1], corner[2]});
  if (!same(2, 3) && !same(3, 0)) mesh.vertices.insert(mesh.vertices.end(), {corner[0], corner[2], corner[3]});
}

/// A grid of vertices, row by row, as quads.
void addGrid(Mesh& mesh, const std::vector<Vertex>& grid, std::size_t columns) {
  for (std::size_t row = 0; row + 1 < grid.size() / columns; ++row) {
    for (std::size_t column = 0; column + 1 < columns; ++column) {
      const std::size_t i = row * columns + column;
      addQuad(mesh, {grid[i], grid[i + 1], grid[i + columns + 1], grid[i + columns]});
    }
  }
}

/// Outward normal of a loft at ring i: perpendicular to the slope between the neighbouring rings.
Vector3f loftNormal(const std::vector<Ring>& rings, std::size_t i, float angle) {
  const Ring& below = rings[i == 0 ? 0 : i - 1];
  const Ring& above = rings[std::min(i + 1, rings.size() - 1)];
  const float dz = above.z_m - below.z_m;
  const float dr = (above.radius_x_m - below.radius_x_m + above.radius_y_m - below.radius_y_m) / 2;
  const float rx = std::max(rings[i].radius_x_m, 1e-4F);
  const float ry = std::max(rings[i].radius_y_m, 1e-4F);
  Vector3f across = Vector3f(std::cos(angle) / rx, std::sin(angle) / ry, 0.0F).normalized();
  const float length = std::hypot(dz, dr);
  if (length < 1e-6F) return across;
  return (across * dz / length - Vector3f::UnitZ() * dr / length).normalized() * (dz < 0 ? -1.0F : 1.0F);
}

}  // namespace

Mesh& Mesh::append(const Mesh& more) {
  vertices.insert(vertices.end(), more.vertices.begin(), more.vertices.end());
  return *this;
}

Mesh& Mesh::transform(const Eigen::Isometry3f& T) {
  for (Vertex& vertex : vertices) {
    vertex.p_m = T * vertex.p_m;
    vertex.normal = T.linear() * vertex.normal;
  }
  return *this;
}

Mesh& Mesh::mapUv(const Vector2f& origin, const Vector2f& span) {
  for (Vertex& vertex : vertices) vertex.uv = origin + vertex.uv.cwiseProduct(span);
  return *this;
}

Mesh box(const Vector3f& size_m, float repeats_per_m) {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0F, 1.0F}) {
      const Vector3f normal = Vector3f::Unit(axis) * side;
      // Upright faces keep "up" along the texture's vertical.
      const Vector3f u = axis == 0 ? Vector3f::UnitY() : Vector3f::UnitX();
      const Vector3f v = axis == 2 ? Vector3f::UnitY() : Vector3f::UnitZ();
      std::array<Vertex, 4> corner;
      const std::array<Vector2f, 4> signs = {Vector2f(-1, -1), Vector2f(1, -1), Vector2f(1, 1), Vector2f(-1, 1)};
      for (std::size_t i = 0; i < 4; ++i) {
        const Vector3f p = (normal + signs[i].x() * u + signs[i].y() * v).cwiseProduct(size_m) / 2;
        const float shift = 0.37F * static_cast<float>(axis) + 0.19F * side;  // faces differ
        corner[i] = {p, normal, Vector2f(u.dot(p) + shift, -v.dot(p)) * repeats_per_m};
      }
      addQuad(mesh, corner);
    }
  }
  return mesh;
}

Mesh loft(const std::vector<Ring>& rings, int segments) {
  std::vector<Vertex> grid;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const Ring& ring = rings[i];
    for (int k = 0; k <= segments; ++k) {
      const float u = static_cast<float>(k) / static_cast<float>(segments);
      const float angle = u * kTwoPi;
      grid.push_back(
          {Vector3f(ring.x_m + ring.radius_x_m * std::cos(angle), ring.radius_y_m * std::sin(angle), ring.z_m),
           loftNormal(rings, i, angle), Vector2f(u, static_cast<float>(i) / static_cast<float>(rings.size() - 1))});
    }
  }
  Mesh mesh;
  addGrid(mesh, grid, static_cast<std::size_t>(segments) + 1);
  return mesh;
}

Mesh rod(const Vector3f& a_m, const Vector3f& b_m, float radius_a_m, float radius_b_m, int segments) {
  const float length = (b_m - a_m).norm();
  Mesh mesh =
      loft({{0, 0, 0}, {0, radius_a_m, radius_a_m}, {length, radius_b_m, radius_b_m}, {length, 0, 0}}, segments);
  Eigen::Isometry3f T = Eigen::Isometry3f::Identity();
  T.linear() = Eigen::Quaternionf::FromTwoVectors(Vector3f::UnitZ(), b_m - a_m).toRotationMatrix();
  T.translation() = a_m;
  return mesh.transform(T);
}

Mesh ellipsoid(const Vector3f& radii_m, int rings, int segments) {
  std::vector<Ring> sections;
  for (int i = 0; i <= rings; ++i) {
    const float polar = kTwoPi / 2 * static_cast<float>(i) / static_cast<float>(rings);
    sections.push_back({-radii_m.z() * std::cos(polar), radii_m.x() * std::sin(polar), radii_m.y() * std::sin(polar)});
  }
  return loft(sections, segments);
}

Mesh panel(const Vector3f& origin_m, const Vector3f& u_m, const Vector3f& v_m) {
  const Vector3f normal = u_m.cross(v_m).normalized();
  Mesh mesh;
  addQuad(mesh, {Vertex{origin_m, normal, {0, 1}}, Vertex{origin_m + u_m, normal, {1, 1}},
                 Vertex{origin_m + u_m + v_m, normal, {1, 0}}, Vertex{origin_m + v_m, normal, {0, 0}}});
  return mesh;
}

Mesh drape(const Vector3f& topA_m, const Vector3f& topB_m, float height_m, float waveLength_m, float amplitude_m) {
  const Vector3f along = topB_m - topA_m;
  const float length = along.norm();
  const Vector3f direction = along / length;
  const Vector3f across = Vector3f::UnitZ().cross(direction);
  const int columns = std::max(8, static_cast<int>(std::ceil(10 * length / waveLength_m)));
  std::vector<Vertex> grid;
  for (const float v : {1.0F, 0.0F}) {
    for (int k = 0; k <= columns; ++k) {
      const float u = static_cast<float>(k) / static_cast<float>(columns);
      const float phase = kTwoPi * u * length / waveLength_m;
      const float swing = amplitude_m * (0.6F + 0.4F * v);  // folds open towards the hem
      const Vector3f p = topA_m + u * along + swing * std::sin(phase) * across - v * height_m * Vector3f::UnitZ();
      const float slope = swing * std::cos(phase) * kTwoPi / waveLength_m;
      grid.push_back({p, (across - slope * direction).normalized(), {u, v}});
    }
  }
  Mesh mesh;
  addGrid(mesh, grid, static_cast<std::size_t>(columns) + 1);
  return mesh;
}

}  // namespace wardslam::synth
