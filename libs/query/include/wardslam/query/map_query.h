#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "wardslam/mapping/semantic_map.h"

namespace wardslam::query {

/// Which objects are wanted. What is not set does not matter.
struct ObjectFilter {
  std::optional<core::ClassId> classId;
  std::optional<std::string> zone;           ///< The centroid lies in this zone, however many lie within it.
  std::optional<Eigen::AlignedBox3d> box_m;  ///< The object's box touches this one.
  std::optional<double> unseenAtLeast_s;     ///< Age: time from when it was last seen to the newest keyframe.
  std::optional<double> unseenAtMost_s;
  std::set<mapping::ObjectState> states = {mapping::ObjectState::Static,
                                           mapping::ObjectState::Moved};  ///< By default what stands there now.

  /// Nothing stands on it: no other object's box reaches into the middle of its footprint (half as long and half as
  /// wide) between 40 % of its height and its top. For a chair that is the seat and the room above it; a chair whose
  /// seat is under a table is not free. People are never in the map, so somebody sitting there is not noticed.
  bool onlyFree = false;
};

/// An object and how far it is.
struct NearObject {
  const mapping::MapObject* object = nullptr;
  double distance_m = 0.0;
};

/// What is known of a place.
struct Place {
  std::vector<const mapping::MapObject*>
      objects;                     ///< Whose boxes hold the point, smallest box first; none that are gone.
  std::vector<std::string> zones;  ///< Innermost (smallest) first.
  unsigned char floor = mapping::FloorPlan::kUnknown;  ///< The floor plan's cell.
};

/// Answers questions about a map. Makes an index when it is built; the map must outlive it and stay unchanged.
/// Answers point into the map. Thread-safe.
class MapQuery {
 public:
  explicit MapQuery(const mapping::SemanticMap& map);
  ~MapQuery();
  MapQuery(MapQuery&&) noexcept;
  MapQuery& operator=(MapQuery&&) noexcept;

  /// In order of ids.
  [[nodiscard]] std::vector<const mapping::MapObject*> objects(const ObjectFilter& filter = {}) const;

  /// The object whose centroid is nearest to a point, as the crow flies.
  [[nodiscard]] std::optional<NearObject> nearest(const Eigen::Vector3d& p_map_m, const ObjectFilter& filter) const;
  [[nodiscard]] std::optional<NearObject> nearest(const Eigen::Vector2d& p_map_m, const ObjectFilter& filter) const;

  /// The object that is the shortest way off, over free cells of the floor plan: from the free cell nearest to the
  /// point (at most kReach_m off) to the first that lies within kReach_m of the object's footprint. Steps go to eight
  /// neighbours on cells of at least 0.1 m, so lengths are up to 8 % too long. Nothing where no way leads.
  [[nodiscard]] std::optional<NearObject> nearestAlongFloor(const Eigen::Vector2d& p_map_m,
                                                            const ObjectFilter& filter) const;
  static constexpr double kReach_m = 0.6;

  [[nodiscard]] Place at(const Eigen::Vector3d& p_map_m) const;

 private:
  struct Index;
  std::unique_ptr<const Index> index_;
};

}  // namespace wardslam::query
