#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <map>
#include <vector>

#include "scene.h"
#include "wardslam/core/camera_model.h"

namespace wardslam::synth {

/// What a pinhole camera can see at most: the space between its four edges, ahead of it and nearer than `far_m`.
class Frustum {
 public:
  Frustum(const core::CameraModel& camera, const Eigen::Isometry3d& T_world_cam, double far_m);

  /// False only where no part of the box (world frame) is inside.
  [[nodiscard]] bool mayShow(const Eigen::AlignedBox3f& box_m) const;

 private:
  std::array<Eigen::Vector4f, 6> planes_;  ///< Inside where n·p + d >= 0.
};

/// Which parts of the building a camera may see into, and where those are.
class CellView {
 public:
  /// False only where the box (world frame) lies in none but parts that are not seen.
  [[nodiscard]] bool mayShow(const Eigen::AlignedBox3f& box_m) const;

 private:
  friend class Chunks;
  struct Cell {
    Eigen::AlignedBox3f box_m;
    bool maySee = true;
  };
  std::vector<Cell> cells_;
};

/// The static triangles of a scene, cut into chunks that are drawn or left out as a whole: grid cells seen from above,
/// and surfaces too large for one. What does not lie in view is not worth a vertex shader.
class Chunks {
 public:
  /// Triangles of one surface that follow each other and lie in one chunk.
  struct Run {
    Material material = Material::Plastic;
    const Vertex* vertices = nullptr;  ///< Three for each triangle; they belong to the scene.
    std::size_t triangles = 0;
    std::size_t firstNumber = 0;  ///< Of its first triangle, counted through the scene.
    std::size_t chunk = 0;
  };

  /// The scene must stay where it is.
  explicit Chunks(const Scene& scene);

  /// In the order of the scene.
  [[nodiscard]] const std::vector<Run>& runs() const { return runs_; }
  /// For each chunk whether it may be seen.
  [[nodiscard]] std::vector<bool> seenFrom(const Eigen::Isometry3d& T_world_cam, const Frustum& frustum) const;

  [[nodiscard]] CellView cellsFrom(const Eigen::Isometry3d& T_world_cam) const;

  static constexpr float kCell_m = 3.0F;

 private:
  struct Chunk {
    int cell = 0;
    Eigen::AlignedBox3f box_m;
  };
  const Scene& scene_;
  std::vector<Run> runs_;
  std::vector<Chunk> chunks_;
  std::map<int, Eigen::AlignedBox3f> cells_;  ///< Around all that stands in them.
};

}  // namespace wardslam::synth
