#include "looks_between_runs.h"

#include <algorithm>
#include <cstdlib>
#include <set>

#include "same_things.h"

namespace wardslam::mapping {
namespace {

using odometry::InDepth;

constexpr int kConvincing = 2;       // looks by which one way of seeing a point outweighs the other
constexpr double kGoneRatio = 2.0;   // so many times what is borne out must be seen through,
constexpr double kLeastSeen = 0.25;  // and so much of the thing
constexpr float kReach_m = 8.0F;     // depth views of most cameras see no farther

/// Of each point of a tile: looks that saw through it, less those that saw it. What is seen later counts as much as
/// all before.
class Judgement {
 public:
  explicit Judgement(const Tile& tile) : tile_(tile), score_(tile.points.size(), 0) {}

  void lookFrom(const OtherLook& look, const std::function<double(ObjectId)>& seenUntil_s) {
    const Eigen::Isometry3f T_cam_tile = look.T_map_cam.inverse().cast<float>() * tile_.T_map_cam;
    if (T_cam_tile.translation().norm() > tile_.radius_m + kReach_m) return;
    for (std::size_t i = 0; i < score_.size(); ++i) {
      const CloudPoint& point = tile_.points[i];
      if (look.stamp_s <= seenUntil_s(point.object)) continue;
      const Eigen::Vector3f p_cam_m = T_cam_tile * point.p_cam_m;
      if (p_cam_m.z() <= 0 || p_cam_m.z() > kReach_m) continue;
      count(odometry::lookUp(*look.depth, look.camera, p_cam_m.cast<double>()), score_[i]);
    }
  }

  void addTo(LaterLooks& found, std::uint32_t tile) const {
    for (std::size_t i = 0; i < score_.size(); ++i) {
      if (std::abs(score_[i]) < kConvincing) continue;
      auto& counts = found.objects[tile_.points[i].object];
      if (score_[i] < 0) {
        ++counts.standing;
      } else {
        ++counts.seenThrough;
        found.seenThrough.push_back({tile, static_cast<std::uint32_t>(i)});
      }
    }
  }

 private:
  static void count(InDepth seen, int& score) {
    if (seen == InDepth::SeenThrough) score = std::min(score + 1, kConvincing);
    if (seen == InDepth::Agrees) score = std::max(score - 1, -kConvincing);
  }

  const Tile& tile_;
  std::vector<int> score_;
};

bool isEarlier(const OtherLook& a, const OtherLook& b) { return a.stamp_s < b.stamp_s; }

}  // namespace

LooksByPiece looksOf(const std::vector<std::shared_ptr<const odometry::Keyframe>>& views,
                     const std::map<KeyframeId, PlacedKeyframe>& keyframes) {
  LooksByPiece looks;
  for (const auto& view : views) {
    const auto placed = keyframes.find(view->id);
    if (placed == keyframes.end() || !view->depth) continue;
    looks[placed->second.piece].push_back({view->stamp_s, placed->second.T_map_cam, view->camera, view->depth});
  }
  return looks;
}

std::vector<OtherLook> looksOfOthers(std::uint32_t piece, const LooksByPiece& looks, const odometry::Pieces& joined) {
  std::vector<OtherLook> others;
  for (const auto& [other, its] : looks) {
    if (other == piece || joined.pieceOf(other) != joined.pieceOf(piece)) continue;
    others.insert(others.end(), its.begin(), its.end());
  }
  std::stable_sort(others.begin(), others.end(), isEarlier);
  return others;
}

std::vector<ObjectId> compareWith(const std::vector<OtherLook>& looks, Part& part, double until_s,
                                  const std::function<void()>& onTile) {
  const auto& records = part.objects.objects();
  const auto seenUntil_s = [&](ObjectId id) {
    const auto record = records.find(id);
    return record == records.end() ? until_s : record->second.lastSeen_s;
  };
  const LaterLooks later = lookLater(part.cloud, looks, seenUntil_s, onTile);
  std::vector<ObjectId> gone;
  for (const auto& [id, counts] : later.objects) {
    if (isGone(counts, part.cloud.pointCounts().at(id))) gone.push_back(id);
  }
  std::set<ObjectId> all;
  for (const auto& [id, record] : records) all.insert(id);
  for (const auto& [id, places_m] : part.cloud.pointsOf(all)) {
    if (wasEmptyBefore(places_m, looks, records.at(id).firstSeen_s)) part.objects.noteEmptyPlace(id);
  }
  for (const ObjectId id : gone) part.objects.lose(id, seenUntil_s(id));
  part.cloud.remove(later.seenThrough);
  for (const auto& [id, counts] : later.objects) part.touched.insert(id);
  return gone;
}

std::vector<std::pair<ObjectId, ObjectId>> sameThingsOf(const std::map<std::uint32_t, Part>& parts,
                                                        const odometry::Pieces& joined, const MappingOptions& options) {
  std::map<std::uint32_t, Part> together;  // rows and records alone, by what the pieces will be
  for (const auto& [piece, part] : parts) {
    Part& all = together.try_emplace(joined.pieceOf(piece), options).first->second;
    for (const auto& [id, row] : part.table.rows()) {
      all.table.restore(row);
      all.objects.restore(id, part.objects.objects().at(id));
    }
    auto pairs = all.objects.pairs();
    pairs.insert(part.objects.pairs().begin(), part.objects.pairs().end());
    all.objects.restore(pairs);
  }
  std::vector<std::pair<ObjectId, ObjectId>> same;
  for (const auto& [piece, all] : together) {
    const auto its = sameBoxes(all.table, all.objects, options.cloud.voxel_m);
    same.insert(same.end(), its.begin(), its.end());
  }
  return same;
}

LaterLooks lookLater(const SemanticCloud& cloud, const std::vector<OtherLook>& looks,
                     const std::function<double(ObjectId)>& seenUntil_s, const std::function<void()>& onTile) {
  LaterLooks found;
  for (std::uint32_t tile = 0; tile < cloud.tiles().size(); ++tile) {
    Judgement judgement(cloud.tiles()[tile]);
    for (const OtherLook& look : looks) judgement.lookFrom(look, seenUntil_s);
    judgement.addTo(found, tile);
    onTile();
  }
  found.objects.erase(0);
  return found;
}

bool isGone(const LaterLooks::Counts& counts, std::size_t points) {
  const auto seenThrough = static_cast<double>(counts.seenThrough);
  return seenThrough >= kGoneRatio * static_cast<double>(counts.standing) && counts.seenThrough > 0 &&
         seenThrough >= kLeastSeen * static_cast<double>(points);
}

bool wasEmptyBefore(const std::vector<Eigen::Vector3f>& places_m, const std::vector<OtherLook>& looks,
                    double firstSeen_s) {
  std::size_t seenThrough = 0;
  for (const Eigen::Vector3f& place_m : places_m) {
    const bool isEmpty = std::any_of(looks.begin(), looks.end(), [&](const OtherLook& look) {
      if (look.stamp_s >= firstSeen_s) return false;
      const Eigen::Vector3d p_cam_m = look.T_map_cam.inverse() * place_m.cast<double>();
      return p_cam_m.z() < kReach_m && odometry::lookUp(*look.depth, look.camera, p_cam_m) == InDepth::SeenThrough;
    });
    if (isEmpty) ++seenThrough;
  }
  return !places_m.empty() && 2 * seenThrough >= places_m.size();
}

}  // namespace wardslam::mapping
