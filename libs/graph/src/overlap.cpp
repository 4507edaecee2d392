#include "overlap.h"

namespace wardslam::graph {
namespace {

constexpr double kNear = 1.5;  // metres and radians of turning, summed: beyond, two looks share little
constexpr double kMetresPerRadian = 1.0;

const KeyframeNode* nearestTo(const Eigen::Isometry3d& T_map_cam, const KeyframeGraph& graph, std::uint32_t piece) {
  const KeyframeNode* nearest = nullptr;
  double least = kNear;
  for (const auto& [id, node] : graph.keyframes()) {
    if (node.submap != piece || !node.keyframe->depth) continue;
    const Eigen::Isometry3d T = T_map_cam.inverse() * node.T_map_cam;
    const double distance = T.translation().norm() + kMetresPerRadian * Eigen::AngleAxisd(T.linear()).angle();
    if (distance >= least) continue;
    least = distance;
    nearest = &node;
  }
  return nearest;
}

}  // namespace

odometry::DepthAgreement depthAcross(const KeyframeGraph& graph, std::uint32_t from, std::uint32_t into,
                                     const Eigen::Isometry3d& T_into_from) {
  odometry::DepthAgreement sum;
  for (const auto& [id, node] : graph.keyframes()) {
    if (node.submap != from || !node.keyframe->depth) continue;
    const Eigen::Isometry3d T_into_cam = T_into_from * node.T_map_cam;
    const KeyframeNode* const other = nearestTo(T_into_cam, graph, into);
    if (other == nullptr) continue;
    const Eigen::Isometry3d T_other_cam = other->T_map_cam.inverse() * T_into_cam;
    const odometry::Keyframe& a = *other->keyframe;
    const odometry::Keyframe& b = *node.keyframe;
    sum += compareDepth(*a.depth, a.camera, *b.depth, b.camera, T_other_cam);
    sum += compareDepth(*b.depth, b.camera, *a.depth, a.camera, T_other_cam.inverse());
  }
  return sum;
}

}  // namespace wardslam::graph
