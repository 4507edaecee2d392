#include "wardslam/graph/mapper_state.h"

#include <opencv2/core.hpp>

#include "lookalikes.h"
#include "loop_confirmation.h"
#include "wardslam/graph/mapper.h"

namespace wardslam::graph {

GraphState KeyframeGraph::state() const {
  GraphState state;
  for (const auto& [id, node] : keyframes_) {
    GraphState::Keyframe& keyframe = state.keyframes.emplace_back();
    keyframe = {id, node.T_map_cam, {}, node.submap, node.isSettled, node.floor};
    for (const auto& [point, keypoint] : node.keypointOf) keyframe.sightings.push_back({point, keypoint});
  }
  for (const auto& [id, node] : points_) {
    const odometry::MapPoint& point = node.point;
    state.points.push_back({id, point.p_map_m, point.viewedFrom_map_m, point.information_per_m2});
  }
  state.fusedInto.assign(fusedInto_.begin(), fusedInto_.end());
  return state;
}

/// How a point looks is known from the runs; and what of it is not in the state was removed.
void KeyframeGraph::resume(const GraphState& state) {
  std::map<PointId, PointNode> points;
  for (const GraphState::Point& known : state.points) {
    PointNode& node = points.emplace(known.id, std::move(points_.at(known.id))).first->second;
    node.point.p_map_m = known.p_map_m;
    node.point.viewedFrom_map_m = known.viewedFrom_map_m;
    node.point.information_per_m2 = known.information_per_m2;
    node.seenBy.clear();
  }
  points_ = std::move(points);
  for (const GraphState::Keyframe& known : state.keyframes) {
    KeyframeNode& node = keyframes_.at(known.id);
    node.T_map_cam = known.T_map_cam;
    node.submap = known.submap;
    node.isSettled = known.isSettled;
    node.floor = known.floor;
    node.keypointOf.clear();
    for (const auto& [point, keypoint] : known.sightings) {
      node.keypointOf.emplace(point, keypoint);
      points_.at(point).seenBy.insert(known.id);
    }
    if (node.keyframe->submap != known.submap) joinedInto_[node.keyframe->submap] = known.submap;
  }
  countAllShared();
  fusedInto_ = {state.fusedInto.begin(), state.fusedInto.end()};
}

MapperState Mapper::state() const {
  MapperState state;
  state.graph = graph_.state();
  state.joins = joins_;
  state.loops = loops_;
  state.hypotheses = confirmation_->hypotheses();
  state.unsettled = confirmation_->unsettled();
  state.apart_m = lookalikes_->apart_m();
  state.doubles = lookalikes_->doubles();
  state.places = remembered_;
  state.random = cv::theRNG().state;
  return state;
}

void Mapper::resume(const std::vector<const SavedGraph*>& runs, const MapperState& state) {
  keptMap_ = runs.front()->map;
  pieces_ = odometry::Pieces(keptMap_);
  for (const SavedGraph* run : runs) takeIn(*run);
  graph_.resume(state.graph);
  for (const odometry::SubmapJoin& join : state.joins) pieces_.join(join);
  joins_ = state.joins;
  loops_ = state.loops;
  confirmation_->resume(state.hypotheses, state.unsettled);
  lookalikes_->resume(state.apart_m, state.doubles);
  for (const auto& places : state.places) remember(places);
  cv::theRNG().state = state.random;
}

}  // namespace wardslam::graph
