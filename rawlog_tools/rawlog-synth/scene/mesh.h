#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace wardslam::synth {

struct Vertex {
  Eigen::Vector3f p_m = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();
  Eigen::Vector2f uv = Eigen::Vector2f::Zero();  ///< (1, 1) = one whole texture, which repeats.
};

/// Triangles: every three vertices make one.
struct Mesh {
  std::vector<Vertex> vertices;

  Mesh& append(const Mesh& more);
  Mesh& transform(const Eigen::Isometry3f& T);
  /// uv = origin + uv * span: shows a part of the texture.
  Mesh& mapUv(const Eigen::Vector2f& origin, const Eigen::Vector2f& span);
};

/// Cross-section of a loft: an ellipse parallel to the xy plane.
struct Ring {
  float z_m = 0.0F;
  float radius_x_m = 0.0F;
  float radius_y_m = 0.0F;
  float x_m = 0.0F;  ///< Centre.
};

/// Centred box. uv in metres on each face, scaled by `repeats_per_m`.
[[nodiscard]] Mesh box(const Eigen::Vector3f& size_m, float repeats_per_m = 1.0F);

/// Skin over the rings, in their order. u runs around from +x over +y, v from the first ring (0) to the last (1).
[[nodiscard]] Mesh loft(const std::vector<Ring>& rings, int segments = 16);

/// Closed round rod from a to b.
[[nodiscard]] Mesh rod(const Eigen::Vector3f& a_m, const Eigen::Vector3f& b_m, float radius_a_m, float radius_b_m,
                       int segments = 8);
[[nodiscard]] Mesh ellipsoid(const Eigen::Vector3f& radii_m, int rings = 8, int segments = 14);

/// Flat rectangle with the corners origin, origin + u, origin + u + v, origin + v; uv covers the texture, v axis
/// of the texture (downwards) along -v. Seen from the side that u × v points to.
[[nodiscard]] Mesh panel(const Eigen::Vector3f& origin_m, const Eigen::Vector3f& u_m, const Eigen::Vector3f& v_m);

/// Upright sheet hanging from a to b, folded in waves across its length; uv in [0, 1]².
[[nodiscard]] Mesh drape(const Eigen::Vector3f& topA_m, const Eigen::Vector3f& topB_m, float height_m,
                         float waveLength_m, float amplitude_m);

[[nodiscard]] inline Eigen::Isometry3f at(float x_m, float y_m, float z_m, float yaw_rad = 0.0F) {
  return Eigen::Translation3f(x_m, y_m, z_m) * Eigen::AngleAxisf(yaw_rad, Eigen::Vector3f::UnitZ());
}

}  // namespace wardslam::synth
