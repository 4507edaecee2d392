#pragma once

#include <Eigen/Geometry>
#include <map>
#include <memory>
#include <vector>

#include "odometry/synthetic_world.h"
#include "wardslam/odometry/keyframe.h"
#include "wardslam/odometry/map_update.h"

namespace wardslam::test {

/// A rotation about the axes and a translation, as a pose.
[[nodiscard]] inline Eigen::Isometry3d makePose(const Eigen::Vector3d& position_m,
                                                const Eigen::Vector3d& rotation_rad = Eigen::Vector3d::Zero()) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() = position_m;
  if (rotation_rad.norm() > 0) {
    T.linear() = Eigen::AngleAxisd(rotation_rad.norm(), rotation_rad.normalized()).toRotationMatrix();
  }
  return T;
}

[[nodiscard]] inline double distance_m(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return (a.translation() - b.translation()).norm();
}

[[nodiscard]] inline double angle_rad(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle();
}

/// Tracking as seen by the map: keyframes in a known world, points recognised as long as they were seen lately.
class SyntheticWalk {
 public:
  static constexpr int kKeyframesPerRound = 36;

  explicit SyntheticWalk(const Noise& noise = {}, std::size_t points = 2000)
      : world_(points, 7, Eigen::Vector3d::Zero(), {4.5, 2.0, 4.5}), noise_(noise) {}

  /// On a circle of a metre, looking outwards: everything is seen again after a round.
  [[nodiscard]] static Eigen::Isometry3d T_world_cam(int step) {
    const Eigen::AngleAxisd heading(2.0 * M_PI * step / kKeyframesPerRound, Eigen::Vector3d::UnitY());
    return Eigen::Isometry3d(heading) * Eigen::Translation3d(0.0, 0.0, 1.0);
  }

  /// The next keyframe on the circle; `slip` is what tracking does not notice of the way to it.
  std::shared_ptr<odometry::Keyframe> step(const Eigen::Isometry3d& slip = Eigen::Isometry3d::Identity()) {
    const Eigen::Isometry3d T_world_cam = SyntheticWalk::T_world_cam(steps_++);
    auto keyframe = std::make_shared<odometry::Keyframe>();
    keyframe->id = truth_.empty() ? 1 : truth_.rbegin()->first + 1;
    keyframe->submap = submap_;
    keyframe->stamp_s = static_cast<double>(keyframe->id);
    if (!startsSubmap_) {
      keyframe->T_previous_cam = truth_.rbegin()->second.inverse() * T_world_cam * slip;
      keyframe->T_map_cam = T_map_cam_ * *keyframe->T_previous_cam;
    }
    startsSubmap_ = false;
    T_map_cam_ = keyframe->T_map_cam;
    truth_[keyframe->id] = T_world_cam;
    keyframe->features = world_.look(T_world_cam, noise_);
    recognise(world_.inSight(T_world_cam), *keyframe);
    return keyframe;
  }

  std::vector<std::shared_ptr<const odometry::Keyframe>> walk(int steps) {
    std::vector<std::shared_ptr<const odometry::Keyframe>> keyframes;
    for (int i = 0; i < steps; ++i) keyframes.push_back(step());
    return keyframes;
  }

  /// The camera goes on by a step that nobody sees.
  void skip() { ++steps_; }

  /// It is carried back by a step.
  void stepBack() { --steps_; }

  /// No point is recognised in what follows; the way goes on.
  void forgetPoints() { remembered_.clear(); }

  /// Tracking knows points again that the map tells it of, and goes by what points turned out to be.
  void recall(const odometry::MapUpdate& update) {
    for (auto& [worldPoint, memory] : remembered_) {
      if (const auto fused = update.fusedPoints.find(memory.id); fused != update.fusedPoints.end())
        memory.id = fused->second;
    }
    const odometry::KeyframeId newest = truth_.rbegin()->first;
    for (const auto& [id, point] : update.recalledPoints) {
      Memory& memory = remembered_[worldPointOf(id)];
      if (memory.id == 0 || memory.lastSeen + kRemembered < newest) memory.id = id;
      memory.lastSeen = newest;
    }
  }

  /// Tracking starts anew, in a map frame of its own.
  void loseTrack() {
    forgetPoints();
    ++submap_;
    startsSubmap_ = true;
  }

  /// Where a keyframe truly is, seen from the first.
  [[nodiscard]] Eigen::Isometry3d T_first_cam(odometry::KeyframeId id) const {
    return truth_.begin()->second.inverse() * truth_.at(id);
  }

  /// What a map point truly is, seen from the first keyframe.
  [[nodiscard]] Eigen::Vector3d p_first_m(odometry::PointId id) const {
    return truth_.begin()->second.inverse() * world_.p_world_m(worldPointOf(id));
  }
  [[nodiscard]] std::size_t worldPointOf(odometry::PointId id) const { return worldPoints_.at(id - 1); }

 private:
  struct Memory {
    odometry::PointId id = 0;
    odometry::KeyframeId lastSeen = 0;
  };
  static constexpr odometry::KeyframeId kRemembered = 3;

  void recognise(const std::vector<std::size_t>& inSight, odometry::Keyframe& keyframe) {
    for (std::size_t keypoint = 0; keypoint < inSight.size(); ++keypoint) {
      Memory& memory = remembered_[inSight[keypoint]];
      if (memory.id == 0 || memory.lastSeen + kRemembered < keyframe.id) {
        worldPoints_.push_back(inSight[keypoint]);
        memory.id = worldPoints_.size();
      }
      memory.lastSeen = keyframe.id;
      keyframe.sightings.push_back({memory.id, keypoint});
    }
  }

  SyntheticWorld world_;
  Noise noise_;
  int steps_ = 0;
  std::uint32_t submap_ = 1;
  bool startsSubmap_ = true;
  Eigen::Isometry3d T_map_cam_ = Eigen::Isometry3d::Identity();
  std::map<odometry::KeyframeId, Eigen::Isometry3d> truth_;  ///< T_world_cam.
  std::map<std::size_t, Memory> remembered_;                 ///< By point of the world.
  std::vector<std::size_t> worldPoints_;                     ///< By map point, from 1.
};

}  // namespace wardslam::test
