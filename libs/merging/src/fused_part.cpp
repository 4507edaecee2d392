#include "fused_part.h"

#include <utility>

#include "wardslam/query/map_difference.h"

namespace wardslam::merging {
namespace {

/// What of a run belongs to the part; its cloud is read for that.
pipeline::EarlierMap shareOf(const Run& run, std::uint32_t piece, const odometry::Pieces& pieces) {
  pipeline::EarlierMap share;
  share.semantic.piece = piece;
  share.semantic.nextObjectId = run.map.semantic.nextObjectId;
  for (const auto& [id, keyframe] : run.map.semantic.keyframes) {
    if (pieces.pieceOf(keyframe.piece) == piece) share.semantic.keyframes.emplace(id, keyframe);
  }
  if (share.semantic.keyframes.empty()) return share;
  for (const auto& [id, object] : run.map.semantic.objects) {
    if (pieces.pieceOf(object.piece) == piece) share.semantic.objects.emplace(id, object);
  }
  for (const auto& [id, object] : run.map.memory.objects) {
    if (pieces.pieceOf(object.piece) == piece) share.memory.objects.emplace(id, object);
  }
  share.memory.pairs = run.map.memory.pairs;
  RunCloud cloud = readCloud(run);
  share.semantic.cloud = std::move(cloud.shown);
  share.memory.tiles = std::move(cloud.known);
  return share;
}

}  // namespace

FusedPart::FusedPart(std::uint32_t piece, const std::vector<Run>& runs, const JoinedRuns& joined,
                     const mapping::MapBuilder::Views& views, mapping::MapBuilder builder,
                     const std::function<void()>& onTile)
    : piece_(piece), builder_(std::move(builder)) {
  for (const Run& run : runs) takeIn(run, joined);
  odometry::MapUpdate moved;
  for (const graph::KeyframeId id : keyframes_) {
    const auto placed = joined.T_joined_cam.find(id);
    if (placed != joined.T_joined_cam.end()) moved.T_map_cam.insert(*placed);
  }
  builder_.apply(moved);
  builder_.compareRuns(views, joined.pieces, onTile);
  for (const odometry::SubmapJoin& join : joined.joins) {
    if (joined.pieces.pieceOf(join.into) != piece_) continue;
    odometry::MapUpdate update;
    update.joined = join;
    builder_.apply(update);
  }
}

void FusedPart::takeIn(const Run& run, const JoinedRuns& joined) {
  const pipeline::EarlierMap share = shareOf(run, piece_, joined.pieces);
  if (share.semantic.keyframes.empty()) return;
  for (const auto& [id, keyframe] : share.semantic.keyframes) keyframes_.insert(id);
  builder_.restore(share.semantic, share.memory);
}

void moveWhatIsGone(Run& run, const JoinedRuns& joined) {
  for (auto& [id, object] : run.map.semantic.objects) {
    if (object.state != mapping::ObjectState::Gone) continue;
    const Eigen::Vector3d place_m = object.centroid_m;
    const auto away_m = [&](const Eigen::Vector3d& p_m) { return (p_m - place_m).norm(); };
    const Eigen::Isometry3d motion = motionAround(away_m, run, object.piece, joined);
    if (!motion.matrix().isIdentity(0.0)) query::moveObject(object, motion);
  }
}

}  // namespace wardslam::merging
