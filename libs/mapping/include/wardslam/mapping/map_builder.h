#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "wardslam/core/label_space.h"
#include "wardslam/knowledge/motion_rules.h"
#include "wardslam/mapping/map_memory.h"
#include "wardslam/mapping/mapping_options.h"
#include "wardslam/mapping/semantic_map.h"
#include "wardslam/mapping/view.h"
#include "wardslam/mapping/zones.h"
#include "wardslam/odometry/keyframe.h"
#include "wardslam/odometry/map_update.h"
#include "wardslam/odometry/pieces.h"

namespace wardslam::mapping {

/// Names parts of a SemanticMap, by their ids.
struct MapParts {
  std::set<odometry::KeyframeId> keyframes;
  std::set<odometry::KeyframeId> tiles;
  std::set<ObjectId> objects;

  [[nodiscard]] bool empty() const { return keyframes.empty() && tiles.empty() && objects.empty(); }
};

/// What keyframes of the map say of the floor.
struct FloorSeen {
  std::size_t keyframes = 0;  ///< Of the map;
  std::size_t seen = 0;       ///< those whose image shows the floor.
  double tilt_rad = 0.0;      ///< Of that floor, on the whole, in the map frame, whose z axis should be up.
  std::string planTrouble;    ///< Why the map has no floor plan, though it was drawn; else empty.
};

/// What a map is told before anything is seen.
struct MapSetting {
  core::LabelSpace labels = core::LabelSpace::coco();
  knowledge::ClassSet moving;  ///< Classes that move by themselves: they never enter the map.
  Zones zones;
  knowledge::ClassSet movable{};  ///< Classes that somebody can move: only these may be found again elsewhere.
};

/// Builds the semantic map (P8–P10) from views and from what the keyframe graph finds out. Everything it holds hangs on
/// keyframes and follows their corrections. What was seen from submaps that are not joined is a piece of its own; the
/// largest piece is the map (odometry::Pieces).
///
/// Plain and single-threaded; the same input gives the same map.
class MapBuilder {
 public:
  MapBuilder(const MappingOptions& options, MapSetting setting);
  ~MapBuilder();
  MapBuilder(MapBuilder&&) noexcept;
  MapBuilder& operator=(MapBuilder&&) noexcept;

  /// Goes on with the map of an earlier run, all its pieces: the piece that is the map stays it. Before anything else,
  /// and again for maps that share no number with those before; then the first one's piece is the map.
  /// What is read is told again as it is, to the last digit, until somebody sees it or its keyframes move. Where the
  /// memory lacks something, it is made up from what the map shows. Zones of an earlier run give way to those of this
  /// one.
  void restore(const SemanticMap& earlier, const MapMemory& memory = {});

  /// Before the views that hang on it.
  void addKeyframe(const odometry::Keyframe& keyframe);

  /// Better poses of keyframes, keyframes that were removed, and submaps that were joined. Ids nobody added are left
  /// out. Keyframes younger than the update move as its newest does. What hung on a removed keyframe hangs on its heir.
  void apply(const odometry::MapUpdate& update);

  /// Works an image in. One whose keyframe nobody added is left out.
  void add(const View& view);

  /// Of pieces that are runs which knew nothing of each other, before they are joined: what stood there later counts.
  /// What a later run saw through is taken away, things with it, which are gone then; and things stand where an earlier
  /// run saw nothing, so they may be some that are gone elsewhere. `joined`: which pieces will be one.
  /// Of the views, id, stamp, camera and depth count. `onTile` hears after each tile; what it throws ends the work, and
  /// then the builder is of no more use.
  using Views = std::vector<std::shared_ptr<const odometry::Keyframe>>;
  void compareRuns(
      const Views& views, const odometry::Pieces& joined, const std::function<void()>& onTile = [] {});

  /// The map as it is now, without pieces that are not joined to it.
  [[nodiscard]] SemanticMap map();

  /// Parts, of any piece, that are new, different or removed since the last call.
  [[nodiscard]] MapParts takeChanges();

  [[nodiscard]] FloorSeen floorSeen() const;

  /// All that is known of objects, and of these tiles, to be restored from.
  [[nodiscard]] MapMemory memory(const std::set<odometry::KeyframeId>& tiles) const;

  /// No more than these keyframes, tiles and objects, of whatever piece; what is missing was removed.
  [[nodiscard]] SemanticMap map(const MapParts& parts);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace wardslam::mapping
