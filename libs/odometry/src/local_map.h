#pragma once

#include <Eigen/Geometry>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "put_off_moves.h"
#include "wardslam/odometry/keyframe.h"
#include "wardslam/odometry/map_point.h"
#include "wardslam/odometry/map_update.h"
#include "wardslam/odometry/odometry_options.h"

namespace wardslam::odometry {

/// The points tracking works against, and which keyframes saw them together. Bounded in number: points unseen for
/// longest are forgotten.
class LocalMap {
 public:
  explicit LocalMap(const LocalMapOptions& options, PointId firstId = 1) : options_(options), nextId_(firstId) {}

  PointId add(const MapPoint& point);
  void addKeyframe(KeyframeId id, const std::vector<PointId>& points);

  /// Null when the point was forgotten.
  [[nodiscard]] const MapPoint* find(PointId id) const;
  /// All of them; where those lie that a loop moved, find() knows.
  [[nodiscard]] const std::map<PointId, MapPoint>& points() const { return points_; }

  /// The points seen by keyframes that saw one of `seeds`, keyframes with most of them first, up to the limit of
  /// neighbours. Sorted by id.
  [[nodiscard]] std::vector<PointId> neighbourhood(const std::vector<PointId>& seeds) const;

  void countVisible(PointId id) { ++points_.at(id).timesVisible; }

  /// The point was found again: refines its position by what this image measured.
  void observe(PointId id, const core::Keypoint& keypoint, const core::CameraModel& camera,
               const Eigen::Isometry3d& T_map_cam, std::uint64_t frame);
  void describe(PointId id, const core::Keypoint& keypoint, const OrbDescriptor& descriptor,
                const Eigen::Isometry3d& T_map_cam);
  /// Remembers what surrounds it.
  void describe(PointId id, core::SemanticDescriptor surroundings) {
    points_.at(id).semanticDescriptor = std::move(surroundings);
  }

  /// Recalled points count as seen in `frame`, the last one. Where the points go, the map turns by `R_map_before`: from
  /// which side each was seen turns along.
  void apply(const std::shared_ptr<const MapUpdate>& update, std::uint64_t frame,
             const Eigen::Matrix3d& R_map_before = Eigen::Matrix3d::Identity());

  void apply(const MapUpdate& update, std::uint64_t frame,
             const Eigen::Matrix3d& R_map_before = Eigen::Matrix3d::Identity()) {
    apply(std::make_shared<const MapUpdate>(update), frame, R_map_before);
  }

  /// With every image: what a loop moved is worked in little by little, so that no image waits for all of it.
  void moveSome();

  /// Moves the points made from that one on, within the map frame.
  void movePoints(PointId first, const Eigen::Isometry3d& correction);

  [[nodiscard]] PointId nextId() const { return nextId_; }  ///< Of the point made next.

  /// Drops points that are rarely found where they should be and, above the limit, those unseen for longest.
  void cull();

  /// Forgets everything; ids are not used again.
  void clear();

 private:
  MapPoint& at(PointId id);
  void remove(PointId id);
  void removeKeyframe(KeyframeId id);
  void link(KeyframeId keyframe, std::vector<PointId>& seen, PointId point);
  void recall(const MapUpdate& update, std::uint64_t frame);
  void fuse(PointId from, PointId into);
  void forgetOldest();

  LocalMapOptions options_;
  PointId nextId_;
  mutable std::map<PointId, MapPoint> points_;  ///< With `putOff_` they are where they belong.
  mutable PutOffMoves putOff_;
  std::map<PointId, std::vector<KeyframeId>> seenBy_;     ///< Of points that are there,
  std::map<KeyframeId, std::vector<PointId>> keyframes_;  ///< and the same the other way round.
};

}  // namespace wardslam::odometry
