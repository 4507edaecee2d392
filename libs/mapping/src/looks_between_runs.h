#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "map_part.h"
#include "semantic_cloud.h"
#include "wardslam/core/camera_model.h"
#include "wardslam/odometry/depth_view.h"
#include "wardslam/odometry/keyframe.h"
#include "wardslam/odometry/pieces.h"

/// What runs that knew nothing of each other say of each other's things: where a keyframe of one saw through, nothing
/// stood at that time.
namespace wardslam::mapping {

struct OtherLook {
  double stamp_s = 0.0;
  Eigen::Isometry3d T_map_cam = Eigen::Isometry3d::Identity();
  core::CameraModel camera;
  std::shared_ptr<const odometry::DepthView> depth;  ///< Not null.
};

/// Of keyframes whose depth is known, by piece, where the builder has them; in order of time.
using LooksByPiece = std::map<std::uint32_t, std::vector<OtherLook>>;
[[nodiscard]] LooksByPiece looksOf(const std::vector<std::shared_ptr<const odometry::Keyframe>>& views,
                                   const std::map<KeyframeId, PlacedKeyframe>& keyframes);

/// Looks of all other pieces that are, or are about to be, joined to this one; in order of time.
[[nodiscard]] std::vector<OtherLook> looksOfOthers(std::uint32_t piece, const LooksByPiece& looks,
                                                   const odometry::Pieces& joined);

/// Takes away what later looks saw through, and notes of what came after others saw its place empty. `until_s`: the end
/// of the run that the part is of. Returns the objects that are gone by that; their points are still there.
std::vector<ObjectId> compareWith(const std::vector<OtherLook>& looks, Part& part, double until_s,
                                  const std::function<void()>& onTile);

/// What looks from later runs say of the points of a cloud: nobody knows what happened in between, so the latest that
/// were seen count.
struct LaterLooks {
  /// Of an object's points, how many are borne out, and how many were seen through.
  struct Counts {
    std::size_t standing = 0;
    std::size_t seenThrough = 0;
  };
  std::map<ObjectId, Counts> objects;
  std::vector<PointRef> seenThrough;  ///< All such points, of objects or not.
};

/// Things of pieces that are about to be joined which are one by their boxes (sameBoxes): {from, into}, the older one
/// last.
[[nodiscard]] std::vector<std::pair<ObjectId, ObjectId>> sameThingsOf(const std::map<std::uint32_t, Part>& parts,
                                                                      const odometry::Pieces& joined,
                                                                      const MappingOptions& options);

/// `seenUntil_s`: since when what is seen of an object (0: of the rest of the cloud) is later. Looks in order of time.
[[nodiscard]] LaterLooks lookLater(
    const SemanticCloud& cloud, const std::vector<OtherLook>& looks, const std::function<double(ObjectId)>& seenUntil_s,
    const std::function<void()>& onTile = [] {});

/// Whether somebody looked and the thing is not there: of what could be seen of it, most was seen through, and that is
/// much of it.
[[nodiscard]] bool isGone(const LaterLooks::Counts& counts, std::size_t points);

/// Whether looks from before `firstSeen_s` saw through half of these places or more (m, map frame).
[[nodiscard]] bool wasEmptyBefore(const std::vector<Eigen::Vector3f>& places_m, const std::vector<OtherLook>& looks,
                                  double firstSeen_s);

}  // namespace wardslam::mapping
