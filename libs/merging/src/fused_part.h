#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "joined_runs.h"
#include "wardslam/mapping/map_builder.h"

namespace wardslam::merging {

/// One part of what runs have become: all that places connect. No other is in memory.
class FusedPart {
 public:
  /// `views`: of all runs; of each, its depth counts. `onTile` hears after each of the part's tiles.
  FusedPart(std::uint32_t piece, const std::vector<Run>& runs, const JoinedRuns& joined,
            const mapping::MapBuilder::Views& views, mapping::MapBuilder builder, const std::function<void()>& onTile);

  [[nodiscard]] mapping::MapBuilder& builder() { return builder_; }
  [[nodiscard]] const std::set<graph::KeyframeId>& keyframes() const { return keyframes_; }

 private:
  void takeIn(const Run& run, const JoinedRuns& joined);

  std::uint32_t piece_;
  std::set<graph::KeyframeId> keyframes_;
  mapping::MapBuilder builder_;
};

/// What is gone has no points in the cloud to follow: it goes with the keyframe nearest to it.
void moveWhatIsGone(Run& run, const JoinedRuns& joined);

}  // namespace wardslam::merging
