#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>

#include "wardslam/core/label_space.h"
#include "wardslam/knowledge/motion_rules.h"
#include "wardslam/mapping/mapping_options.h"
#include "wardslam/mapping/semantic_map.h"
#include "wardslam/mapping/view.h"
#include "wardslam/odometry/keyframe.h"
#include "wardslam/odometry/map_update.h"

namespace wardslam::mapping {

/// Which parts of a SemanticMap differ from what they were. An id that the map no longer holds was removed.
struct MapChanges {
  std::set<odometry::KeyframeId> keyframes;  ///< New or moved.
  std::set<odometry::KeyframeId> tiles;
  std::set<ObjectId> objects;

  [[nodiscard]] bool empty() const { return keyframes.empty() && tiles.empty() && objects.empty(); }
};

/// Builds the semantic map (P8–P10) from views and from what the keyframe graph finds out. Everything it holds hangs on
/// keyframes and follows their corrections. What was seen from submaps that are not joined to the first is kept, but is
/// not part of the map.
///
/// Plain and single-threaded; the same input gives the same map.
class MapBuilder {
 public:
  /// `moving`: the classes that move by themselves and never enter the map.
  MapBuilder(const MappingOptions& options, core::LabelSpace labels, const knowledge::ClassSet& moving);
  ~MapBuilder();
  MapBuilder(MapBuilder&&) noexcept;
  MapBuilder& operator=(MapBuilder&&) noexcept;

  /// Before the views that hang on it.
  void addKeyframe(const odometry::Keyframe& keyframe);

  /// Better poses of keyframes, and submaps that were joined. Ids nobody added are left out.
  void apply(const odometry::MapUpdate& update);

  /// Works an image in. One whose keyframe nobody added is left out.
  void add(const View& view);

  /// The map as it is now.
  [[nodiscard]] SemanticMap map();

  /// What differs in map() since the last call.
  [[nodiscard]] MapChanges takeChanges();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace wardslam::mapping
