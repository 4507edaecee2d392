#pragma once

#include <cstdint>
#include <memory>
#include <set>

#include "wardslam/core/label_space.h"
#include "wardslam/knowledge/motion_rules.h"
#include "wardslam/mapping/mapping_options.h"
#include "wardslam/mapping/semantic_map.h"
#include "wardslam/mapping/view.h"
#include "wardslam/mapping/zones.h"
#include "wardslam/odometry/keyframe.h"
#include "wardslam/odometry/map_update.h"

namespace wardslam::mapping {

/// Names parts of a SemanticMap, by their ids.
struct MapParts {
  std::set<odometry::KeyframeId> keyframes;
  std::set<odometry::KeyframeId> tiles;
  std::set<ObjectId> objects;

  [[nodiscard]] bool empty() const { return keyframes.empty() && tiles.empty() && objects.empty(); }
};

/// What a map is told before anything is seen.
struct MapSetting {
  core::LabelSpace labels = core::LabelSpace::coco();
  knowledge::ClassSet moving;  ///< Classes that move by themselves: they never enter the map.
  Zones zones;
};

/// Builds the semantic map (P8–P10) from views and from what the keyframe graph finds out. Everything it holds hangs on
/// keyframes and follows their corrections. What was seen from submaps that are not joined to the first is kept, but is
/// not part of the map.
///
/// Plain and single-threaded; the same input gives the same map.
class MapBuilder {
 public:
  MapBuilder(const MappingOptions& options, MapSetting setting);
  ~MapBuilder();
  MapBuilder(MapBuilder&&) noexcept;
  MapBuilder& operator=(MapBuilder&&) noexcept;

  /// Goes on with the map of an earlier run, which is submap 0 from now on. Before anything else.
  void restore(const SemanticMap& earlier);

  /// Before the views that hang on it.
  void addKeyframe(const odometry::Keyframe& keyframe);

  /// Better poses of keyframes, keyframes that were removed, and submaps that were joined. Ids nobody added are left
  /// out. Keyframes younger than the update move as its newest does. What hung on a removed keyframe hangs on its heir.
  void apply(const odometry::MapUpdate& update);

  /// Works an image in. One whose keyframe nobody added is left out.
  void add(const View& view);

  /// The map as it is now.
  [[nodiscard]] SemanticMap map();

  /// Parts that are new, different or removed since the last call.
  [[nodiscard]] MapParts takeChanges();

  /// The map with no more keyframes, tiles and objects than these; what is missing in it was removed.
  [[nodiscard]] SemanticMap map(const MapParts& parts);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace wardslam::mapping
