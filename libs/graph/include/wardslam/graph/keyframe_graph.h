#pragma once

#include <Eigen/Geometry>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "wardslam/odometry/keyframe.h"
#include "wardslam/odometry/map_point.h"

namespace wardslam::graph {

struct GraphState;
using odometry::KeyframeId;
using odometry::PointId;

/// A keyframe as it stands in the graph: its pose and what it is known to see change, its image does not.
struct KeyframeNode {
  std::shared_ptr<const odometry::Keyframe> keyframe;
  Eigen::Isometry3d T_map_cam = Eigen::Isometry3d::Identity();
  std::map<PointId, std::size_t> keypointOf;  ///< Points it sees, and the key point of each.
  std::uint32_t submap = 0;                   ///< Keyframes of one submap share a map frame.
  bool isHeld = false;                        ///< Stays as it is, see KeyframeGraph::hold().
  bool isRestored = false;                    ///< Of an earlier run.
  bool isSettled = false;                     ///< Stays where an earlier run left it, see KeyframeGraph::unsettle().
  KeyframeId floor = 0;  ///< The floor it stands on, by a keyframe that stood there first; 0: none known.

  [[nodiscard]] bool mayMove() const { return !isHeld && !isSettled; }
};

/// A map point and the keyframes that see it.
struct PointNode {
  odometry::MapPoint point;
  std::set<KeyframeId> seenBy;
  bool isHeld = false;
};

/// Keyframes and points, tied by sightings. Two keyframes that see the same points are covisible.
class KeyframeGraph {
 public:
  /// Places the keyframe relative to the one before it. Points not known yet are made from their key point's depth.
  void insert(const std::shared_ptr<const odometry::Keyframe>& keyframe);

  /// A keyframe of an earlier run, at the pose it carries; its points lie where `p_map_m` says, whether this keyframe
  /// measured their depth or not. It is settled: what comes is fitted to it, and it does not move for that.
  void restore(const std::shared_ptr<const odometry::Keyframe>& keyframe,
               const std::map<PointId, Eigen::Vector3d>& p_map_m);

  /// What is there by now is known for good: whoever changes the graph leaves its poses and positions as they are and
  /// removes none of it, which is more than being settled. It can be recognised, and what comes can be tied to it.
  void hold();

  [[nodiscard]] bool isAnySettled(std::uint32_t submap) const;

  /// What earlier runs settled in this submap is adjusted with the rest from now on.
  void unsettle(std::uint32_t submap);

  [[nodiscard]] const std::map<KeyframeId, KeyframeNode>& keyframes() const { return keyframes_; }
  [[nodiscard]] const std::map<PointId, PointNode>& points() const { return points_; }

  /// Keyframes that share points with this one and how many, most first.
  [[nodiscard]] std::vector<std::pair<KeyframeId, std::size_t>> covisible(KeyframeId id) const;

  void setPose(KeyframeId id, const Eigen::Isometry3d& T_map_cam);
  void setFloor(KeyframeId id, KeyframeId floor) { keyframes_.at(id).floor = floor; }
  void setPosition(PointId id, const Eigen::Vector3d& p_map_m);
  void movePoint(PointId id, const Eigen::Isometry3d& correction);  ///< Within the map frame, with all known of it.
  void removeSighting(KeyframeId keyframe, PointId point);          ///< And the point, when nobody else sees it.

  /// With its sightings, and the points nobody else sees. Returns those. The newest keyframe must stay.
  std::vector<PointId> remove(KeyframeId id);

  /// `from` turned out to be `into`: its sightings become the other's, also those in keyframes to come.
  void fuse(PointId from, PointId into);

  /// All keyframes of one submap now belong to the other, in whose frame they are settled no more; poses are not
  /// touched.
  void joinSubmaps(std::uint32_t from, std::uint32_t into);

  /// What changed since the keyframes came, for resume() of a graph to which the same ones have come.
  [[nodiscard]] GraphState state() const;
  void resume(const GraphState& state);

  /// What follows is a trial: poses, positions, sightings removed, points fused, submaps joined and what is unsettled
  /// can be taken back whole. Costs what is changed, not what is there. No keyframe comes or goes meanwhile.
  void beginTrial();
  void endTrial() { trial_.reset(); }  ///< What was changed stays.
  void takeBack();                     ///< All is as it was when the trial began.

 private:
  /// What was, of what changed since the trial began.
  struct Trial {
    std::map<KeyframeId, Eigen::Isometry3d> T_map_cam;
    std::map<KeyframeId, std::uint32_t> submap;
    std::set<KeyframeId> settled;
    std::map<KeyframeId, std::map<PointId, std::size_t>> keypointOf;
    std::map<KeyframeId, std::map<KeyframeId, std::size_t>> shared;
    std::map<PointId, odometry::MapPoint> moved;
    std::map<PointId, PointNode> points;
    std::vector<PointId> fused;
    std::map<std::uint32_t, std::uint32_t> joinedInto;
  };

  void unsettle(KeyframeId id, KeyframeNode& node);
  /// So many points more, or less, that the keyframe shares with each of those.
  void countShared(KeyframeId id, const std::set<KeyframeId>& seenBy, int change);
  void countAllShared();
  void keepShared(KeyframeId id);
  void keepSightings(KeyframeId id);
  void keep(PointId id);
  void keepPlace(PointId id);
  void insertAt(const std::shared_ptr<const odometry::Keyframe>& keyframe, const Eigen::Isometry3d& T_map_cam,
                const std::map<PointId, Eigen::Vector3d>& p_map_m);
  [[nodiscard]] std::uint32_t currentSubmapOf(const odometry::Keyframe& keyframe) const;
  [[nodiscard]] PointId currentIdOf(PointId id) const;

  std::map<KeyframeId, KeyframeNode> keyframes_;
  std::map<PointId, PointNode> points_;
  std::map<KeyframeId, std::map<KeyframeId, std::size_t>> shared_;  ///< How many points two have in common.
  std::map<PointId, PointId> fusedInto_;
  std::map<std::uint32_t, std::uint32_t> joinedInto_;
  std::optional<Trial> trial_;
};

}  // namespace wardslam::graph
