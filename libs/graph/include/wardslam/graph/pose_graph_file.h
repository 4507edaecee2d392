#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <map>

#include "wardslam/graph/graph_options.h"
#include "wardslam/graph/saved_graph.h"

/// Keyframes and what ties them as a text file of MRPT's (`.graph`, the format of TORO and HOG-man), which graph-slam
/// opens. Angles and information are in MRPT's order.
namespace wardslam::graph {

/// Nodes: the keyframes of the map, T_map_cam. Edges, one between two keyframes: what a loop says; else what tracking
/// measured from one to the next; else what adjustment found of those that share points. Throws core::InputError when
/// it cannot be written.
void writePoseGraph(const SavedGraph& graph, const std::filesystem::path& file, const PoseGraphOptions& options = {});

/// Where the nodes of such a file are. Throws core::InputError for a file that is none, or holds no nodes.
[[nodiscard]] std::map<KeyframeId, Eigen::Isometry3d> readPoseGraph(const std::filesystem::path& file);

}  // namespace wardslam::graph
