#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

#include "wardslam/odometry/keyframe.h"
#include "wardslam/odometry/map_update.h"

namespace wardslam::odometry {

/// Which pieces there are: submaps that were joined are one piece, and only keyframes of one piece share a frame. The
/// piece with most keyframes is "the map"; of two alike the one begun first.
class Pieces {
 public:
  /// `map`: the piece of an earlier run that stays the map, however large others grow: goals and zones are in its
  /// frame.
  explicit Pieces(std::optional<std::uint32_t> map = std::nullopt) : kept_(map) {}

  void add(KeyframeId keyframe, std::uint32_t submap);
  void remove(KeyframeId keyframe);
  void join(const SubmapJoin& join);
  void apply(const MapUpdate& update);  ///< What it says of removed keyframes and joined submaps.

  /// The piece a submap belongs to by now. A piece goes by the number of one of its submaps.
  [[nodiscard]] std::uint32_t pieceOf(std::uint32_t submap) const;

  /// Nothing as long as there is no keyframe.
  [[nodiscard]] std::optional<std::uint32_t> map() const;
  [[nodiscard]] bool isMap(std::uint32_t submap) const { return map() == pieceOf(submap); }

  /// How many keyframes each piece has; none of them is empty.
  [[nodiscard]] const std::map<std::uint32_t, std::size_t>& sizes() const { return sizes_; }

 private:
  std::optional<std::uint32_t> kept_;
  std::map<KeyframeId, std::uint32_t> submapOf_;
  std::map<std::uint32_t, std::uint32_t> joinedInto_;
  std::map<std::uint32_t, std::size_t> sizes_;
};

}  // namespace wardslam::odometry
