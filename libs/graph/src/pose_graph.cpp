#include "pose_graph.h"

#include <ceres/ceres.h>
#include <ceres/rotation.h>
#include <mrpt/containers/yaml.h>
#include <mrpt/graphslam/levmarq.h>

#include <algorithm>
#include <map>
#include <utility>

#include "wardslam/core/mrpt_compat.h"
#include "wardslam/odometry/observation_error.h"

namespace wardslam::graph {
namespace {

using odometry::PoseVector;

constexpr double kPointsOfFullWeight = 100.0;
/// Edges are taken for some ten times less sure than adjusted neighbours are, all alike. Floors are not, and would
/// shake the keyframes by the noise of each image's depth.
constexpr double kFloorWeight = 0.01;
constexpr double kLoopKernel = 5.0;  // standard deviations; drift makes true loops miss by tens at first

/// How far the pose of `to` seen from `from` is from what the edge says, whitened.
struct EdgeError {
  Eigen::Matrix<double, 3, 3> R_from_to;
  Eigen::Vector3d t_from_to_m;
  Eigen::Vector3d positionWeight;
  Eigen::Vector3d rotationWeight;

  template <class T>
  bool operator()(const T* T_map_from, const T* T_map_to, T* error) const {
    Eigen::Matrix<T, 3, 3> R_map_from;
    Eigen::Matrix<T, 3, 3> R_map_to;
    ceres::AngleAxisToRotationMatrix(T_map_from, R_map_from.data());
    ceres::AngleAxisToRotationMatrix(T_map_to, R_map_to.data());
    const Eigen::Map<const Eigen::Matrix<T, 3, 1>> from_map(T_map_from + 3);
    const Eigen::Map<const Eigen::Matrix<T, 3, 1>> to_map(T_map_to + 3);

    const Eigen::Matrix<T, 3, 1> position = R_map_from.transpose() * (to_map - from_map) - t_from_to_m.cast<T>();
    const Eigen::Matrix<T, 3, 3> rotation = R_from_to.transpose().cast<T>() * (R_map_from.transpose() * R_map_to);
    Eigen::Matrix<T, 3, 1> angleAxis;
    ceres::RotationMatrixToAngleAxis(rotation.data(), angleAxis.data());
    Eigen::Map<Eigen::Matrix<T, 6, 1>> whitened(error);
    whitened << positionWeight.cast<T>().cwiseProduct(position), rotationWeight.cast<T>().cwiseProduct(angleAxis);
    return true;
  }
};

void addEdge(PoseGraph& poses, KeyframeId from, KeyframeId to, const Eigen::Isometry3d& T_from_to, double weight,
             const PoseGraphOptions& options) {
  PoseGraph::constraint_t edge;
  edge.mean = core::toMrpt(T_from_to);
  edge.cov_inv.setZero();
  for (int i = 0; i < 3; ++i) {
    edge.cov_inv(i, i) = weight / (options.position_sigma_m * options.position_sigma_m);
    edge.cov_inv(3 + i, 3 + i) = weight / (options.rotation_sigma_rad * options.rotation_sigma_rad);
  }
  poses.insertEdgeAtEnd(from, to, edge);
}

EdgeError errorOf(const PoseGraph::constraint_t& edge) {
  const Eigen::Isometry3d T_from_to = core::fromMrpt(edge.mean);
  const Eigen::Matrix<double, 6, 1> weight = edge.cov_inv.asEigen().diagonal().cwiseSqrt();
  return {T_from_to.linear(), T_from_to.translation(), weight.head<3>(), weight.tail<3>()};
}

void optimiseWithCeres(PoseGraph& poses, const std::set<std::pair<KeyframeId, KeyframeId>>& loopEdges,
                       std::set<KeyframeId> constant, FloorTies floors, const PoseGraphOptions& options) {
  std::map<KeyframeId, PoseVector> variables;
  for (const auto& [id, pose] : poses.nodes) variables[id] = odometry::toPoseVector(core::fromMrpt(pose));
  ceres::Problem problem;
  for (const auto& [ends, edge] : poses.edges) {
    auto* cost = new ceres::AutoDiffCostFunction<EdgeError, 6, 6, 6>(new EdgeError(errorOf(edge)));
    auto* loss = loopEdges.count(ends) != 0 ? new ceres::CauchyLoss(kLoopKernel) : nullptr;
    problem.AddResidualBlock(cost, loss, variables.at(ends.first).data(), variables.at(ends.second).data());
  }
  const auto poseOf = [&](KeyframeId id) {
    const auto pose = variables.find(id);
    return pose == variables.end() ? nullptr : pose->second.data();
  };
  floors.addTo(problem, PoseKind::MapFromCam, poseOf, kFloorWeight);
  if (constant.empty()) constant.insert(poses.root);
  bool isAnchored = false;
  for (const KeyframeId id : constant) {
    const auto pose = variables.find(id);
    if (pose == variables.end() || !problem.HasParameterBlock(pose->second.data())) continue;
    problem.SetParameterBlockConstant(pose->second.data());
    isAnchored = true;
  }
  if (!isAnchored) return;
  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  solver.max_num_iterations = options.max_iterations;
  solver.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &problem, &summary);
  for (auto& [id, pose] : poses.nodes) pose = core::toMrpt(odometry::toIsometry(variables.at(id)));
}

void optimiseWithLevmarq(PoseGraph& poses, const PoseGraphOptions& options) {
  mrpt::containers::yaml parameters = mrpt::containers::yaml::Map();
  parameters["max_iterations"] = options.max_iterations;
  mrpt::graphslam::TResultInfoSpaLevMarq result;
  mrpt::graphslam::optimize_graph_spa_levmarq(poses, result, nullptr, parameters);
}

}  // namespace

PoseGraph makePoseGraph(const KeyframeGraph& graph, std::uint32_t submap, const std::vector<Loop>& loops,
                        const PoseGraphOptions& options) {
  PoseGraph poses;
  for (const auto& [id, node] : graph.keyframes()) {
    if (node.submap != submap) continue;
    if (poses.nodes.empty()) poses.root = id;
    poses.nodes[id] = core::toMrpt(node.T_map_cam);
  }
  KeyframeId previous = 0;
  for (const auto& [id, pose] : poses.nodes) {
    const KeyframeNode& node = graph.keyframes().at(id);
    const KeyframeId before = std::exchange(previous, id);
    if (node.isHeld) continue;
    for (const auto& [older, shared] : graph.covisible(id)) {
      const bool isNext = older == before;
      const bool isTied = isNext || static_cast<int>(shared) >= options.min_shared_points;
      if (older > id || !isTied || poses.nodes.count(older) == 0) continue;
      const Eigen::Isometry3d T_older_id = graph.keyframes().at(older).T_map_cam.inverse() * node.T_map_cam;
      addEdge(poses, older, id, T_older_id, static_cast<double>(shared) / kPointsOfFullWeight, options);
    }
    if (before == 0 || poses.edgeExists(before, id)) continue;
    const Eigen::Isometry3d T_before_id = graph.keyframes().at(before).T_map_cam.inverse() * node.T_map_cam;
    addEdge(poses, before, id, T_before_id, 1.0 / kPointsOfFullWeight, options);  // shared nothing: a weak tie
  }
  for (const Loop& loop : loops) {
    if (poses.nodes.count(loop.older) == 0) continue;
    addEdge(poses, loop.older, loop.newer, loop.T_older_newer, loop.inliers / kPointsOfFullWeight, options);
  }
  return poses;
}

void optimise(PoseGraph& poses, const std::set<std::pair<KeyframeId, KeyframeId>>& loopEdges,
              const std::set<KeyframeId>& held, const PoseGraphOptions& options, const FloorTies& floors) {
  if (options.solver == PoseGraphSolver::Levmarq) {
    optimiseWithLevmarq(poses, options);
  } else {
    optimiseWithCeres(poses, loopEdges, held, floors, options);
  }
}

}  // namespace wardslam::graph
