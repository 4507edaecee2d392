#include "wardslam/graph/pose_graph_file.h"

#include <exception>
#include <iterator>

#include "pose_graph.h"
#include "wardslam/core/atomic_file.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/mrpt_compat.h"

namespace wardslam::graph {
namespace {

/// What tracking measured, from one keyframe to the next.
void setOdometry(PoseGraph& poses, const SavedGraph& graph) {
  for (const auto& keyframe : graph.keyframes) {
    if (!keyframe->T_previous_cam) continue;
    const auto edge = poses.edges.find({keyframe->id - 1, keyframe->id});
    if (edge != poses.edges.end()) edge->second.mean = core::toMrpt(*keyframe->T_previous_cam);
  }
}

/// MRPT keeps one edge of those with the same ends when it reads; a loop says more than what was adjusted to it.
void keepLastOfEach(PoseGraph& poses) {
  for (auto edge = poses.edges.begin(); edge != poses.edges.end();) {
    const auto next = std::next(edge);
    edge = next != poses.edges.end() && next->first == edge->first ? poses.edges.erase(edge) : next;
  }
}

}  // namespace

void writePoseGraph(const SavedGraph& graph, const std::filesystem::path& file, const PoseGraphOptions& options) {
  KeyframeGraph keyframes;
  for (const auto& keyframe : graph.keyframes) keyframes.restore(keyframe, graph.p_map_m);
  PoseGraph poses = makePoseGraph(keyframes, graph.map, graph.loops, options);
  setOdometry(poses, graph);
  keepLastOfEach(poses);
  core::replaceAtomically(file, [&poses](const std::filesystem::path& partial) {
    try {
      poses.saveToTextFile(partial.string());
    } catch (const std::exception&) {
      throw core::InputError(partial.string() + ": cannot be written");
    }
  });
}

std::map<KeyframeId, Eigen::Isometry3d> readPoseGraph(const std::filesystem::path& file) {
  PoseGraph poses;
  try {
    poses.loadFromTextFile(file.string());
  } catch (const std::exception&) {
    throw core::InputError(file.string() +
                           ": is no graph of poses in 3D, as `map export --graph` and graph-slam write");
  }
  if (poses.nodes.empty()) throw core::InputError(file.string() + ": holds no nodes (VERTEX3)");
  std::map<KeyframeId, Eigen::Isometry3d> T_map_cam;
  for (const auto& [id, pose] : poses.nodes) T_map_cam.emplace(id, core::fromMrpt(pose));
  return T_map_cam;
}

}  // namespace wardslam::graph
