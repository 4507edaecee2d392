#include "rendering/in_view.h"

namespace wardslam::synth {
namespace {

/// Plane through a camera at p, inside on the side n points to.
Eigen::Vector4f planeOf(const Eigen::Vector3d& n, const Eigen::Vector3d& p) {
  Eigen::Vector4d plane;
  plane << n, -n.dot(p);
  return plane.cast<float>();
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

Cells::Cells(const Scene& scene) : scene_(scene) {
  for (const Thing& thing : scene.things) {
    Eigen::AlignedBox3f& box_m = boxes_m_[thing.cell];
    for (const Surface& surface : thing.surfaces) {
      for (const Vertex& vertex : surface.mesh.vertices) box_m.extend(vertex.p_m);
    }
  }
}

CellView Cells::seenFrom(const Eigen::Isometry3d& T_world_cam) const {
  CellView view;
  if (!scene_.mayBeSeen) return view;
  for (const auto& [cell, box_m] : boxes_m_) view.cells_.push_back({box_m, scene_.mayBeSeen(cell, T_world_cam)});
  return view;
}

}  // namespace wardslam::synth
