#include "doubles.h"

#include <optional>
#include <set>

#include "overlap.h"

namespace wardslam::graph {
namespace {

constexpr double kLeastApart_m = 4.0;  // rooms that look the same are 8 m apart and more; in each, one may stand aside
constexpr double kMostRoom_m = 8.0;
constexpr std::size_t kMostAsked = 24;
constexpr double kSameView = 1.0;  // metres and radians of turning, summed

/// All from which it may see what it sees, and those of other pieces, of which nothing says how far they are.
std::set<KeyframeId> around(const KeyframeGraph& graph, KeyframeId id) {
  const KeyframeNode& here = graph.keyframes().at(id);
  std::set<KeyframeId> around{id};
  for (const auto& [other, shared] : graph.covisible(id)) around.insert(other);
  for (const auto& [other, node] : graph.keyframes()) {
    const double apart_m = (node.T_map_cam.translation() - here.T_map_cam.translation()).norm();
    if (node.submap != here.submap || apart_m < kLeastApart_m) around.insert(other);
  }
  return around;
}

/// The one of a piece that looks most from there to where it does, as long as that is about the same.
std::optional<KeyframeId> lookingFrom(const KeyframeGraph& graph, const Eigen::Isometry3d& T_map_cam,
                                      std::uint32_t piece) {
  std::optional<KeyframeId> nearest;
  double least = kSameView;
  for (const auto& [id, node] : graph.keyframes()) {
    if (node.submap != piece) continue;
    const Eigen::Isometry3d T = T_map_cam.inverse() * node.T_map_cam;
    const double distance = T.translation().norm() + Eigen::AngleAxisd(T.linear()).angle();
    if (distance >= least) continue;
    least = distance;
    nearest = id;
  }
  return nearest;
}

}  // namespace

std::vector<Loop> doublesOf(const KeyframeGraph& graph, KeyframeId id, const PlaceRecognition& places,
                            const LoopVerification& verification, const PlaceRecognitionOptions& options) {
  std::set<KeyframeId> known = around(graph, id);
  std::vector<Loop> doubles;
  int looks = 0;
  for (const KeyframeId alike : places.candidates(graph.keyframes().at(id).keyframe->features, known)) {
    if (known.count(alike) != 0) continue;
    if (++looks > options.max_candidates) break;
    const auto place = verification.placeAround(graph, alike);
    known.insert(place.begin(), place.end());
    if (auto look = verification.look(graph, id, place)) doubles.push_back(std::move(*look));
  }
  return doubles;
}

std::vector<KeyframeId> roomAround(const KeyframeGraph& graph, KeyframeId id) {
  const KeyframeNode& here = graph.keyframes().at(id);
  std::vector<KeyframeId> room;
  for (const auto& [other, node] : graph.keyframes()) {
    const double apart_m = (node.T_map_cam.translation() - here.T_map_cam.translation()).norm();
    if (node.submap == here.submap && apart_m < kMostRoom_m) room.push_back(other);
  }
  if (room.size() <= kMostAsked) return room;
  std::vector<KeyframeId> some{id};
  for (std::size_t i = 0; i < kMostAsked; ++i) some.push_back(room[i * room.size() / kMostAsked]);
  return some;
}

bool explains(const KeyframeGraph& graph, const Loop& look, const Loop& join, const LoopVerification& verification,
              const LoopVerificationOptions& options) {
  const auto T_map = [&](KeyframeId id) { return graph.keyframes().at(id).T_map_cam; };
  const Eigen::Isometry3d T_double_room = T_map(look.older) * look.T_older_newer * T_map(look.newer).inverse();
  const Eigen::Isometry3d T_map_seen = T_double_room * T_map(join.older) * join.T_older_newer;
  const std::uint32_t piece = graph.keyframes().at(join.older).submap;
  const std::uint32_t joined = graph.keyframes().at(join.newer).submap;
  const auto surfaces = depthAcross(graph, joined, piece, T_map_seen * T_map(join.newer).inverse());
  if (surfaces.contradiction() > options.max_contradiction) return false;
  const auto there = lookingFrom(graph, T_map_seen, piece);
  return !there || verification.look(graph, join.newer, verification.placeAround(graph, *there));
}

}  // namespace wardslam::graph
