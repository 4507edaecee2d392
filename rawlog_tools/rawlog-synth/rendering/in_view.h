#pragma once

#include <Eigen/Geometry>
#include <array>
#include <map>
#include <vector>

#include "scene/scene.h"
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
  friend class Cells;
  struct Cell {
    Eigen::AlignedBox3f box_m;
    bool maySee = true;
  };
  std::vector<Cell> cells_;
};

/// The parts of a scene's building.
class Cells {
 public:
  /// The scene must stay where it is.
  explicit Cells(const Scene& scene);

  [[nodiscard]] CellView seenFrom(const Eigen::Isometry3d& T_world_cam) const;

 private:
  const Scene& scene_;
  std::map<int, Eigen::AlignedBox3f> boxes_m_;  ///< Around all that stands in them.
};

}  // namespace wardslam::synth
