// What a SemanticCloud remembers from one run to the next.
#include <algorithm>

#include "semantic_cloud.h"
#include "wardslam/core/depth_noise.h"

namespace wardslam::mapping {
namespace {

constexpr core::DepthNoise kSavedNoise;  // what older maps were measured with is not known

}  // namespace

void SemanticCloud::restore(KeyframeId keyframe, const Eigen::Isometry3d& T_map_cam, const SemanticCloudTile& saved) {
  TileMemory memory;
  memory.reserve(saved.points.size());
  for (const SemanticPoint& point : saved.points) {
    PointMemory& m = memory.emplace_back();
    m.p_cam_m = point.p_cam_m;
    m.color_rgb = point.color_rgb;
    m.sightings = point.sightings;
    const double sigma_m = kSavedNoise.sigma_m(static_cast<double>(point.p_cam_m.z()));
    m.sigma_m = static_cast<float>(std::min(sigma_m, options_.max_sigma_m));  // or it would not have been saved
    m.precision_m2 = std::min(kMostPrecision_m2, static_cast<float>(point.sightings) / (m.sigma_m * m.sigma_m));
    m.evidence = kMostEvidence;
    m.votes[0] = {point.object, static_cast<float>(point.sightings)};
    m.object = point.object;
  }
  restore(keyframe, T_map_cam, memory);
}

void SemanticCloud::restore(KeyframeId keyframe, const Eigen::Isometry3d& T_map_cam, const TileMemory& saved) {
  addTile(keyframe, T_map_cam);
  const std::uint32_t index = tileOf_.at(keyframe);
  Tile& tile = tiles_[index];
  tile.points.reserve(saved.size());
  for (const PointMemory& m : saved) {
    CloudPoint& point = tile.points.emplace_back();
    point.p_cam_m = m.p_cam_m;
    point.color_rgb = Eigen::Vector3f(m.color_rgb[0], m.color_rgb[1], m.color_rgb[2]);
    point.precision_m2 = m.precision_m2;
    point.sigma_m = m.sigma_m;
    point.votes = ObjectVotes(m.votes);
    noteVotes(index, point.votes);
    noteVote(index, m.object);
    point.sightings = m.sightings;
    point.evidence = m.evidence;
    setObject(point, m.object);
    tile.radius_m = std::max(tile.radius_m, point.p_cam_m.norm());
  }
  enterUnchanged(index);
}

TileMemory SemanticCloud::remember(const Tile& tile) {
  TileMemory memory;
  memory.reserve(tile.points.size());
  for (const CloudPoint& point : tile.points) {
    PointMemory& m = memory.emplace_back();
    m.p_cam_m = point.p_cam_m;
    for (std::size_t i = 0; i < 3; ++i) {
      m.color_rgb[i] = cv::saturate_cast<std::uint8_t>(point.color_rgb[static_cast<Eigen::Index>(i)]);
    }
    m.precision_m2 = point.precision_m2;
    m.sigma_m = point.sigma_m;
    m.votes = point.votes.votes();
    m.object = point.object;
    m.sightings = point.sightings;
    m.evidence = point.evidence;
  }
  return memory;
}

/// A point whose cell is taken goes to a free one beside it: it was in another before its keyframe moved, by less than
/// points are put in their cells anew for.
void SemanticCloud::enterUnchanged(std::uint32_t tileIndex) {
  const auto cell_m = static_cast<float>(options_.voxel_m);
  std::vector<PointRef> gone;
  for (std::uint32_t i = 0; i < tiles_[tileIndex].points.size(); ++i) {
    const PointRef ref{tileIndex, i};
    const Eigen::Vector3f p_map_m = mapPosition(ref);
    bool isPlaced = false;
    for (int n = 0; n < 27 && !isPlaced; ++n) {
      constexpr int kSteps[] = {0, 1, -1};  // its own cell first
      const Eigen::Vector3f step(static_cast<float>(kSteps[n % 3]), static_cast<float>(kSteps[n / 3 % 3]),
                                 static_cast<float>(kSteps[n / 9]));
      const std::uint64_t cell = cellOf(p_map_m + cell_m * step, cell_m);
      isPlaced = index_.try_emplace(cell, ref).second;
      if (isPlaced) point(ref).cell = cell;
    }
    if (isPlaced) continue;
    merge(ref, index_.at(cellOf(p_map_m, cell_m)));
    gone.push_back(ref);
  }
  erase(std::move(gone));
}

}  // namespace wardslam::mapping
