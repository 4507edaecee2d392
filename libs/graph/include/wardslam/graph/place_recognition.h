#pragma once

#include <memory>
#include <set>
#include <vector>

#include "wardslam/graph/graph_options.h"
#include "wardslam/odometry/keyframe.h"

namespace wardslam::graph {

/// Which old keyframes look like a new one: an index over binary descriptors (locality-sensitive hashing), without a
/// vocabulary that would have to be trained or downloaded. Knows nothing of geometry.
class PlaceRecognition {
 public:
  explicit PlaceRecognition(const PlaceRecognitionOptions& options);
  ~PlaceRecognition();
  PlaceRecognition(PlaceRecognition&&) noexcept;

  /// Keyframes in order; one can be found once min_keyframe_gap others have followed it, or up to
  /// twice as many: the index is rebuilt now and then. When another submap begins, all before it can be found.
  void add(const odometry::Keyframe& keyframe);

  /// Keyframes, none of `excluded`, that share most looks with these features, likeliest first.
  [[nodiscard]] std::vector<odometry::KeyframeId> candidates(const core::Features& features,
                                                             const std::set<odometry::KeyframeId>& excluded) const;

 private:
  struct Index;

  void extendIndex(std::size_t youngest);

  PlaceRecognitionOptions options_;
  std::vector<std::pair<odometry::KeyframeId, cv::Mat>> waiting_;  ///< Too young to be found.
  std::uint32_t submap_ = 0;
  std::unique_ptr<Index> index_;
};

}  // namespace wardslam::graph
