#include "bundle_adjustment.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "floor_ties.h"
#include "wardslam/odometry/observation_error.h"

namespace wardslam::graph {
namespace {

using odometry::ObservationError;
using odometry::PoseVector;

constexpr std::size_t kMaxDensePoses = 60;

class StopWhenAsked : public ceres::IterationCallback {
 public:
  explicit StopWhenAsked(const std::atomic<bool>* stop) : stop_(stop) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& /*summary*/) override {
    return stop_ != nullptr && *stop_ ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

 private:
  const std::atomic<bool>* stop_;
};

/// One sighting in the window.
struct Edge {
  KeyframeId keyframe;
  PointId point;
  const core::Keypoint* keypoint;
  ObservationError error;
};

/// Costs nothing. Ceres eliminates what has few neighbours before the poses, and a plane with the points; but that
/// would tie all that stand on it to each other, each to each. Beside a point, which goes first, a plane stays with the
/// poses.
struct Weightless {
  template <class T>
  bool operator()(const T* plane, const T* point, T* error) const {
    error[0] = T(0.0) * (plane[0] + point[0]);
    return true;
  }
};

std::set<KeyframeId> keyframesOf(const AdjustmentWindow& window) {
  std::set<KeyframeId> keyframes = window.moved;
  keyframes.insert(window.fixed.begin(), window.fixed.end());
  return keyframes;
}

/// The window's poses, points and floors as the solver's variables.
class AdjustmentProblem {
 public:
  AdjustmentProblem(const KeyframeGraph& graph, const AdjustmentWindow& window, const BundleAdjustmentOptions& options)
      : options_(options), floors_(graph, keyframesOf(window)) {
    for (const PointId id : window.points) {
      const PointNode& node = graph.points().at(id);
      if (node.seenBy.size() < 2) continue;  // one sighting tells nothing of poses
      points_.emplace(id, node.point.p_map_m);
      if (node.isHeld) heldPoints_.insert(id);
      const bool isSeenLess = !leastSeen_ || node.seenBy.size() < graph.points().at(*leastSeen_).seenBy.size();
      if (!node.isHeld && isSeenLess) leastSeen_ = id;
    }
    for (const KeyframeId id : window.moved) add(graph.keyframes().at(id), id);
    for (const KeyframeId id : window.fixed) add(graph.keyframes().at(id), id);
    for (const KeyframeId id : window.fixed) fixed_.insert(id);
  }

  void solve(int maxIterations, const std::atomic<bool>* stop) {
    ceres::Problem problem;
    for (Edge& edge : edges_) {
      // A point behind the camera has no error that could be made less, and one such would end it all.
      if (std::isfinite(squaredError(edge))) addResidual(edge, problem);
    }
    addFloors(problem);
    for (const KeyframeId id : fixed_) {
      double* pose = poses_.at(id).data();
      if (problem.HasParameterBlock(pose)) problem.SetParameterBlockConstant(pose);
    }
    for (const PointId id : heldPoints_) {
      double* position = points_.at(id).data();
      if (problem.HasParameterBlock(position)) problem.SetParameterBlockConstant(position);
    }
    if (problem.NumResidualBlocks() == 0) return;
    ceres::Solver::Options solver;
    const bool isSmall = poses_.size() <= kMaxDensePoses;
    solver.linear_solver_type = isSmall ? ceres::DENSE_SCHUR : ceres::SPARSE_SCHUR;
    // Ceres finds out itself what to eliminate: an order given by hand is one of addresses, other in every run.
    solver.max_num_iterations = maxIterations;
    solver.function_tolerance = 1e-4;
    solver.logging_type = ceres::SILENT;
    StopWhenAsked stopWhenAsked(stop);
    solver.callbacks.push_back(&stopWhenAsked);
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem, &summary);
  }

  /// Writes poses and points back and removes the sightings that do not fit.
  odometry::MapUpdate apply(KeyframeGraph& graph) const {
    odometry::MapUpdate update;
    for (const auto& [id, pose] : poses_) {
      if (fixed_.count(id) != 0) continue;
      update.T_map_cam.emplace(id, odometry::toIsometry(pose).inverse());
      graph.setPose(id, update.T_map_cam.at(id));
    }
    for (const auto& [id, point] : points_) {
      if (heldPoints_.count(id) != 0) continue;
      update.p_map_m.emplace(id, point);
      graph.setPosition(id, point);
    }
    for (const Edge& edge : edges_) {
      if (squaredError(edge) < odometry::chiSquareOf(*edge.keypoint)) continue;
      graph.removeSighting(edge.keyframe, edge.point);
      if (graph.points().count(edge.point) == 0) update.removedPoints.push_back(edge.point);
    }
    return update;
  }

 private:
  void add(const KeyframeNode& node, KeyframeId id) {
    poses_.emplace(id, odometry::toPoseVector(node.T_map_cam.inverse()));
    for (const auto& [point, index] : node.keypointOf) {
      if (points_.count(point) == 0) continue;
      const core::Keypoint& keypoint = node.keyframe->features.keypoints[index];
      const ObservationError error(keypoint, node.keyframe->camera, options_.pixel_sigma_px,
                                   options_.depth_sigma_scale);
      edges_.push_back({id, point, &keypoint, error});
    }
  }

  [[nodiscard]] double squaredError(const Edge& edge) const {
    return edge.error.squared(poses_.at(edge.keyframe), points_.at(edge.point));
  }

  void addResidual(Edge& edge, ceres::Problem& problem) {
    auto* functor = new ObservationError(edge.error);
    ceres::CostFunction* cost = nullptr;
    if (edge.keypoint->hasDepth()) {
      cost = new ceres::AutoDiffCostFunction<ObservationError, 3, 6, 3>(functor);
    } else {
      cost = new ceres::AutoDiffCostFunction<ObservationError, 2, 6, 3>(functor);
    }
    auto* loss = new ceres::HuberLoss(std::sqrt(odometry::chiSquareOf(*edge.keypoint)));
    problem.AddResidualBlock(cost, odometry::weightedLoss(loss, *edge.keypoint), poses_.at(edge.keyframe).data(),
                             points_.at(edge.point).data());
  }

  void addFloors(ceres::Problem& problem) {
    const auto poseOf = [&](KeyframeId id) {
      double* pose = poses_.at(id).data();
      return problem.HasParameterBlock(pose) ? pose : nullptr;
    };
    floors_.addTo(problem, PoseKind::CamFromMap, poseOf);
    if (!leastSeen_ || !problem.HasParameterBlock(points_.at(*leastSeen_).data())) return;
    for (double* plane : floors_.variablePlanes()) {
      if (!problem.HasParameterBlock(plane)) continue;
      problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Weightless, 1, 3, 3>(new Weightless), nullptr, plane,
                               points_.at(*leastSeen_).data());
    }
  }

  const BundleAdjustmentOptions& options_;
  FloorTies floors_;
  std::optional<PointId> leastSeen_;
  std::map<KeyframeId, PoseVector> poses_;  // T_cam_map
  std::map<PointId, Eigen::Vector3d> points_;
  std::set<KeyframeId> fixed_;
  std::set<PointId> heldPoints_;
  std::vector<Edge> edges_;
};

constexpr int kPointsThatTie = 15;

bool isTiedToHeld(const KeyframeGraph& graph, const AdjustmentWindow& window) {
  const auto isHeld = [&](PointId id) { return graph.points().at(id).isHeld; };
  return std::count_if(window.points.begin(), window.points.end(), isHeld) >= kPointsThatTie;
}

bool isTiedToFixed(const KeyframeGraph& graph, const AdjustmentWindow& window) {
  const auto isFixed = [&](KeyframeId id) { return window.fixed.count(id) != 0; };
  const auto isSeenByFixed = [&](PointId id) {
    const auto& seenBy = graph.points().at(id).seenBy;
    return std::any_of(seenBy.begin(), seenBy.end(), isFixed);
  };
  return std::count_if(window.points.begin(), window.points.end(), isSeenByFixed) >= kPointsThatTie;
}

/// The map frame is that of what is held, or the first keyframe's; where it is out of reach something else must hold
/// still.
void holdFirst(const KeyframeGraph& graph, AdjustmentWindow& window) {
  const KeyframeId first = graph.keyframes().begin()->first;
  if (window.moved.erase(first) != 0) window.fixed.insert(first);
  if (window.fixed.empty() && !window.moved.empty() && !isTiedToHeld(graph, window))
    window.fixed.insert(window.moved.extract(window.moved.begin()).value());
}

}  // namespace

AdjustmentWindow localWindow(const KeyframeGraph& graph, KeyframeId newest, const BundleAdjustmentOptions& options) {
  AdjustmentWindow window;
  window.moved.insert(newest);
  const auto isHeld = [&graph](KeyframeId id) { return graph.keyframes().at(id).isHeld; };
  for (const auto& [id, shared] : graph.covisible(newest)) {
    const bool mayMove = graph.keyframes().at(id).mayMove();
    const bool isNeighbour = shared >= static_cast<std::size_t>(options.min_shared_points) && mayMove;
    if (isNeighbour && window.moved.size() < static_cast<std::size_t>(options.window)) window.moved.insert(id);
  }
  std::map<KeyframeId, std::size_t> others;
  for (const KeyframeId id : window.moved) {
    for (const auto& [point, keypoint] : graph.keyframes().at(id).keypointOf) window.points.insert(point);
  }
  for (const PointId point : window.points) {
    for (const KeyframeId id : graph.points().at(point).seenBy) {
      if (window.moved.count(id) == 0 && !isHeld(id)) ++others[id];
    }
  }
  std::vector<std::pair<std::size_t, KeyframeId>> bySharedPoints;
  for (const auto& [id, shared] : others) bySharedPoints.emplace_back(shared, id);
  std::sort(bySharedPoints.rbegin(), bySharedPoints.rend());
  for (const auto& [shared, id] : bySharedPoints) {
    if (window.fixed.size() < static_cast<std::size_t>(options.max_fixed_keyframes)) window.fixed.insert(id);
  }
  holdFirst(graph, window);
  return window;
}

AdjustmentWindow globalWindow(const KeyframeGraph& graph, std::uint32_t submap) {
  AdjustmentWindow window;
  for (const auto& [id, node] : graph.keyframes()) {
    if (node.submap != submap || !node.mayMove()) continue;
    window.moved.insert(id);
    for (const auto& [point, keypoint] : node.keypointOf) window.points.insert(point);
  }
  for (const auto& [id, node] : graph.keyframes()) {
    if (node.submap != submap || !node.isSettled) continue;
    const auto isMoved = [&window](const auto& sighting) { return window.points.count(sighting.first) != 0; };
    if (std::any_of(node.keypointOf.begin(), node.keypointOf.end(), isMoved)) window.fixed.insert(id);
  }
  if (window.moved.empty() || isTiedToHeld(graph, window) || isTiedToFixed(graph, window)) return window;
  window.fixed.insert(window.moved.extract(window.moved.begin()).value());
  return window;
}

odometry::MapUpdate adjust(KeyframeGraph& graph, const AdjustmentWindow& window, const BundleAdjustmentOptions& options,
                           int maxIterations, const std::atomic<bool>* stop) {
  AdjustmentProblem problem(graph, window, options);
  problem.solve(maxIterations, stop);
  return problem.apply(graph);
}

}  // namespace wardslam::graph
