#include "chunks.h"

#include <cmath>
#include <tuple>

namespace wardslam::synth {
namespace {

/// Plane through a camera at p, inside on the side n points to.
Eigen::Vector4f planeOf(const Eigen::Vector3d& n, const Eigen::Vector3d& p) {
  Eigen::Vector4d plane;
  plane << n, -n.dot(p);
  return plane.cast<float>();
}

Eigen::AlignedBox3f boxOf(const Vertex* corners) {
  Eigen::AlignedBox3f box(corners[0].p_m);
  return box.extend(corners[1].p_m).extend(corners[2].p_m);
}

/// Part of the building, then either a grid cell (a = 0) or a large surface of its own (a > 0).
using ChunkKey = std::tuple<int, std::size_t, long, long>;

ChunkKey keyOf(int cell, const Eigen::AlignedBox3f& box, std::size_t surfaceNumber) {
  if (box.sizes().maxCoeff() > Chunks::kCell_m) return {cell, surfaceNumber, 0, 0};
  const Eigen::Vector3f middle = box.center();
  return {cell, 0, std::lround(middle.x() / Chunks::kCell_m), std::lround(middle.y() / Chunks::kCell_m)};
}

}  // namespace

Frustum::Frustum(const core::CameraModel& camera, const Eigen::Isometry3d& T_world_cam, double far_m) {
  const Eigen::Vector3d p = T_world_cam.translation();
  const auto ray = [&](double x_px, double y_px) -> Eigen::Vector3d {
    return T_world_cam.linear() * camera.unproject({x_px, y_px}, 1.0);
  };
  const double right = camera.width_px;
  const double bottom = camera.height_px;
  const std::array<Eigen::Vector3d, 4> corners = {ray(-1, -1), ray(right, -1), ray(right, bottom), ray(-1, bottom)};
  for (std::size_t i = 0; i < 4; ++i) planes_[i] = planeOf(corners[i].cross(corners[(i + 1) % 4]).normalized(), p);
  const Eigen::Vector3d ahead = T_world_cam.linear().col(2);
  planes_[4] = planeOf(ahead, p);
  planes_[5] = planeOf(-ahead, p + far_m * ahead);
}

bool Frustum::mayShow(const Eigen::AlignedBox3f& box_m) const {
  for (const Eigen::Vector4f& plane : planes_) {
    const Eigen::Vector3f n = plane.head<3>();
    // The corner of the box that lies farthest inside.
    const Eigen::Vector3f corner = (n.array() >= 0).select(box_m.max(), box_m.min());
    if (n.dot(corner) + plane.w() < 0) return false;
  }
  return true;
}

bool CellView::mayShow(const Eigen::AlignedBox3f& box_m) const {
  bool isInCell = false;
  for (const Cell& cell : cells_) {
    if (!cell.box_m.intersects(box_m)) continue;
    if (cell.maySee) return true;
    isInCell = true;
  }
  return !isInCell;
}

Chunks::Chunks(const Scene& scene) : scene_(scene) {
  std::map<ChunkKey, std::size_t> chunkOf;
  std::size_t number = 0;
  std::size_t surfaceNumber = 0;
  for (const Thing& thing : scene.things) {
    for (const Surface& surface : thing.surfaces) {
      ++surfaceNumber;
      const auto& vertices = surface.mesh.vertices;
      std::size_t previous = chunks_.size();  // none
      bool isNewSurface = true;
      for (std::size_t i = 0; i + 2 < vertices.size(); i += 3, ++number) {
        const Eigen::AlignedBox3f box = boxOf(&vertices[i]);
        const auto [entry, isNew] = chunkOf.try_emplace(keyOf(thing.cell, box, surfaceNumber), chunks_.size());
        if (isNew) chunks_.push_back({thing.cell, box});
        const std::size_t chunk = entry->second;
        chunks_[chunk].box_m.extend(box);
        if (isNewSurface || chunk != previous) runs_.push_back({surface.material, &vertices[i], 0, number, chunk});
        ++runs_.back().triangles;
        previous = chunk;
        isNewSurface = false;
      }
    }
  }
  for (const Chunk& chunk : chunks_) cells_[chunk.cell].extend(chunk.box_m);
}

CellView Chunks::cellsFrom(const Eigen::Isometry3d& T_world_cam) const {
  CellView view;
  if (!scene_.mayBeSeen) return view;
  for (const auto& [cell, box_m] : cells_) view.cells_.push_back({box_m, scene_.mayBeSeen(cell, T_world_cam)});
  return view;
}

std::vector<bool> Chunks::seenFrom(const Eigen::Isometry3d& T_world_cam, const Frustum& frustum) const {
  std::map<int, bool> cells;
  const auto mayBeSeen = [&](int cell) {
    if (!scene_.mayBeSeen) return true;
    const auto [entry, isNew] = cells.try_emplace(cell, true);
    if (isNew) entry->second = scene_.mayBeSeen(cell, T_world_cam);
    return entry->second;
  };
  std::vector<bool> seen;
  seen.reserve(chunks_.size());
  for (const Chunk& chunk : chunks_) seen.push_back(mayBeSeen(chunk.cell) && frustum.mayShow(chunk.box_m));
  return seen;
}

}  // namespace wardslam::synth
