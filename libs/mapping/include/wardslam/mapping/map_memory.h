#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "wardslam/mapping/map_object.h"
#include "wardslam/mapping/semantic_cloud_tile.h"

/// What a MapBuilder knows besides the map it tells of, and needs to go on as if there had been no end in between.
namespace wardslam::mapping {

/// How much speaks for a point being of an object (0 = of none).
struct ObjectVote {
  ObjectId object = 0;
  float weight = 0.0F;
};

/// A point of the cloud, be it shown to others or not yet seen often enough.
struct PointMemory {
  Eigen::Vector3f p_cam_m = Eigen::Vector3f::Zero();  ///< In the camera frame of the tile's keyframe.
  std::array<std::uint8_t, 3> color_rgb{};
  float precision_m2 = 0.0F;  ///< Sum of 1/σ² of its sightings: its weight.
  float sigma_m = 0.0F;       ///< Depth noise of its best sighting.
  std::array<ObjectVote, 3> votes{};
  ObjectId object = 0;  ///< The winner of the votes.
  std::uint16_t sightings = 0;
  std::int8_t evidence = 0;  ///< For its being there.
};

using TileMemory = std::vector<PointMemory>;

/// What is known of an object besides its points, be it told to others or not yet.
struct ObjectMemory {
  std::map<core::ClassId, double> votes;  ///< Sum of confidences, by class.
  int views = 0;                          ///< That saw it,
  int expected = 0;                       ///< and that had it in plain sight.
  int missed = 0;                         ///< Of those, the last ones in a row that did not see it.
  double firstSeen_s = 0.0;
  double lastSeen_s = 0.0;
  Eigen::Vector3f lastPlace_m = Eigen::Vector3f::Zero();  ///< Of the detection that saw it last.
  double handled_s = 0.0;                                 ///< When it was last in somebody's hands.
  int viewsToRest = 0;                                    ///< It must be seen so many times more to count as put down.
  std::size_t erased = 0;                                 ///< Points taken away since it was seen last.
  double gone_s = 0.0;                                    ///< When it was last found to be gone.
  bool placeWasEmpty = false;                             ///< Where it was seen first, images had seen through before.
  ObjectState state = ObjectState::Static;
};

/// Whether two records are one thing, by what images showed.
struct PairMemory {
  int together = 0;  ///< Views in which one detection covered both,
  int apart = 0;     ///< and in which each had its own.
};

struct MapMemory {
  std::map<std::uint64_t, TileMemory> tiles;  ///< By keyframe id.
  std::map<ObjectId, ObjectMemory> objects;
  std::map<std::pair<ObjectId, ObjectId>, PairMemory> pairs;  ///< The lesser id first.
};

}  // namespace wardslam::mapping
