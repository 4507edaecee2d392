#pragma once

#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "wardslam/graph/graph_options.h"
#include "wardslam/odometry/keyframe.h"

namespace wardslam::graph {

class DescriptorIndex;

/// Which old keyframes look like a new one: an index over binary descriptors (locality-sensitive hashing), without a
/// vocabulary that would have to be trained or downloaded. Knows nothing of geometry.
class PlaceRecognition {
 public:
  explicit PlaceRecognition(const PlaceRecognitionOptions& options);
  ~PlaceRecognition();
  PlaceRecognition(PlaceRecognition&&) noexcept;

  /// `descriptors`: rows of 32 bytes (CV_8UC1), of what will be seen there again. It can be found once
  /// min_keyframe_gap others have been added or build() was called.
  void add(odometry::KeyframeId keyframe, const cv::Mat& descriptors);
  void build();

  /// It is not found any more.
  void remove(odometry::KeyframeId keyframe);

  /// Keyframes, none of `excluded`, that share most looks with these features, likeliest first: enough for
  /// max_candidates places, of each of which several may be among them.
  [[nodiscard]] std::vector<odometry::KeyframeId> candidates(const core::Features& features,
                                                             const std::set<odometry::KeyframeId>& excluded) const;

 private:
  PlaceRecognitionOptions options_;
  std::vector<std::pair<odometry::KeyframeId, cv::Mat>> waiting_;  ///< Cannot be found yet.
  std::unique_ptr<DescriptorIndex> index_;
};

}  // namespace wardslam::graph
