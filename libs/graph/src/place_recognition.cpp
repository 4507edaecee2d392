#include "wardslam/graph/place_recognition.h"

#include <algorithm>
#include <map>

#include "descriptor_index.h"

namespace wardslam::graph {
namespace {

constexpr std::size_t kKeyframesOfAPlace = 6;
constexpr std::size_t kNeighbours = 3;

}  // namespace

PlaceRecognition::PlaceRecognition(const PlaceRecognitionOptions& options)
    : options_(options), index_(std::make_unique<DescriptorIndex>()) {}
PlaceRecognition::~PlaceRecognition() = default;
PlaceRecognition::PlaceRecognition(PlaceRecognition&&) noexcept = default;

void PlaceRecognition::add(odometry::KeyframeId keyframe, const cv::Mat& descriptors) {
  waiting_.emplace_back(keyframe, descriptors);
  if (waiting_.size() > static_cast<std::size_t>(options_.min_keyframe_gap)) build();
}

void PlaceRecognition::build() {
  for (const auto& [keyframe, descriptors] : waiting_) index_->add(keyframe, descriptors);
  waiting_.clear();
}

void PlaceRecognition::remove(odometry::KeyframeId keyframe) {
  const auto waits = [&](const auto& entry) { return entry.first == keyframe; };
  const auto waiting = std::find_if(waiting_.begin(), waiting_.end(), waits);
  if (waiting != waiting_.end()) {
    waiting_.erase(waiting);
  } else {
    index_->remove(keyframe);
  }
}

std::vector<odometry::KeyframeId> PlaceRecognition::candidates(const core::Features& features,
                                                               const std::set<odometry::KeyframeId>& excluded) const {
  std::map<odometry::KeyframeId, int> votes;
  for (int feature = 0; feature < features.descriptors.rows; ++feature) {
    std::set<odometry::KeyframeId> votedFor;
    for (const auto& [distance, keyframe] :
         index_->nearest(features.descriptors.ptr(feature), kNeighbours, options_.max_descriptor_distance)) {
      if (excluded.count(keyframe) == 0 && votedFor.insert(keyframe).second) ++votes[keyframe];
    }
  }
  std::vector<std::pair<int, odometry::KeyframeId>> ranking;
  for (const auto& [keyframe, count] : votes) {
    if (count >= options_.min_votes) ranking.emplace_back(count, keyframe);
  }
  std::sort(ranking.rbegin(), ranking.rend());
  ranking.resize(std::min(ranking.size(), kKeyframesOfAPlace * static_cast<std::size_t>(options_.max_candidates)));
  std::vector<odometry::KeyframeId> likely;
  for (const auto& [count, keyframe] : ranking) likely.push_back(keyframe);
  return likely;
}

}  // namespace wardslam::graph
