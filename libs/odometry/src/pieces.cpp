#include "wardslam/odometry/pieces.h"

#include <algorithm>

namespace wardslam::odometry {

void Pieces::add(KeyframeId keyframe, std::uint32_t submap) {
  submapOf_[keyframe] = submap;
  ++sizes_[pieceOf(submap)];
}

void Pieces::remove(KeyframeId keyframe) {
  const auto known = submapOf_.find(keyframe);
  if (known == submapOf_.end()) return;
  const auto size = sizes_.find(pieceOf(known->second));
  if (--size->second == 0) sizes_.erase(size);
  submapOf_.erase(known);
}

void Pieces::join(const SubmapJoin& join) {
  for (auto& [submap, piece] : joinedInto_) {
    if (piece == join.from) piece = join.into;
  }
  joinedInto_[join.from] = join.into;
  const auto from = sizes_.find(join.from);
  if (from == sizes_.end()) return;
  sizes_[join.into] += from->second;
  sizes_.erase(from);
}

void Pieces::apply(const MapUpdate& update) {
  for (const RemovedKeyframe& removed : update.removedKeyframes) remove(removed.id);
  if (update.joined) join(*update.joined);
}

std::uint32_t Pieces::pieceOf(std::uint32_t submap) const {
  const auto joined = joinedInto_.find(submap);
  return joined == joinedInto_.end() ? submap : joined->second;
}

std::optional<std::uint32_t> Pieces::map() const {
  if (kept_) return pieceOf(*kept_);
  const auto isSmaller = [](const auto& a, const auto& b) { return a.second < b.second; };
  const auto largest = std::max_element(sizes_.begin(), sizes_.end(), isSmaller);
  return largest == sizes_.end() ? std::nullopt : std::optional(largest->first);
}

}  // namespace wardslam::odometry
