#include "wardslam/graph/place_recognition.h"

#include <algorithm>
#include <map>
#include <opencv2/flann.hpp>

namespace wardslam::graph {
namespace {

// Locality-sensitive hashing: more tables find more, longer keys compare less. Looking into the buckets beside a key's
// own, too, compares ten times as much: ORB's bits go together, so that some buckets hold a good part of all rows.
constexpr int kTables = 12;
constexpr int kKeyBits = 15;
constexpr int kProbes = 0;
constexpr std::size_t kKeyframesOfAPlace = 6;
constexpr int kNeighbours = 3;

}  // namespace

struct PlaceRecognition::Index {
  cv::Mat descriptors;
  std::vector<odometry::KeyframeId> keyframeOf;  ///< Per row.
  std::unique_ptr<cv::flann::Index> search;      ///< Over all rows; rebuilt now and then.
  std::set<odometry::KeyframeId> removed;        ///< Whose rows go with the next building.

  void dropRemoved() {
    if (removed.empty()) return;
    cv::Mat kept;
    std::vector<odometry::KeyframeId> keyframeOfKept;
    for (int row = 0; row < descriptors.rows; ++row) {
      const auto keyframe = keyframeOf[static_cast<std::size_t>(row)];
      if (removed.count(keyframe) != 0) continue;
      kept.push_back(descriptors.row(row));
      keyframeOfKept.push_back(keyframe);
    }
    descriptors = kept;
    keyframeOf = std::move(keyframeOfKept);
    removed.clear();
  }
};

PlaceRecognition::PlaceRecognition(const PlaceRecognitionOptions& options)
    : options_(options), index_(std::make_unique<Index>()) {}
PlaceRecognition::~PlaceRecognition() = default;
PlaceRecognition::PlaceRecognition(PlaceRecognition&&) noexcept = default;

void PlaceRecognition::add(odometry::KeyframeId keyframe, const cv::Mat& descriptors) {
  waiting_.emplace_back(keyframe, descriptors);
  if (waiting_.size() > static_cast<std::size_t>(options_.min_keyframe_gap)) build();
}

void PlaceRecognition::build() {
  index_->search.reset();  // it looks into the rows, which may move when some are added
  index_->dropRemoved();
  for (const auto& [keyframe, descriptors] : waiting_) {
    index_->descriptors.push_back(descriptors);
    index_->keyframeOf.insert(index_->keyframeOf.end(), static_cast<std::size_t>(descriptors.rows), keyframe);
  }
  waiting_.clear();
  if (index_->descriptors.empty()) return;
  index_->search = std::make_unique<cv::flann::Index>(
      index_->descriptors, cv::flann::LshIndexParams(kTables, kKeyBits, kProbes), cvflann::FLANN_DIST_HAMMING);
}

void PlaceRecognition::remove(odometry::KeyframeId keyframe) {
  const auto waits = [&](const auto& entry) { return entry.first == keyframe; };
  const auto waiting = std::find_if(waiting_.begin(), waiting_.end(), waits);
  if (waiting != waiting_.end()) {
    waiting_.erase(waiting);
  } else {
    index_->removed.insert(keyframe);
  }
}

std::vector<odometry::KeyframeId> PlaceRecognition::candidates(const core::Features& features,
                                                               const std::set<odometry::KeyframeId>& excluded) const {
  if (!index_->search || features.size() == 0) return {};
  cv::Mat rows;
  cv::Mat distances;
  index_->search->knnSearch(features.descriptors, rows, distances, kNeighbours, cv::flann::SearchParams());
  std::map<odometry::KeyframeId, int> votes;
  for (int feature = 0; feature < rows.rows; ++feature) {
    std::set<odometry::KeyframeId> votedFor;
    for (int i = 0; i < rows.cols; ++i) {
      const int row = rows.at<int>(feature, i);
      if (row < 0 || distances.at<int>(feature, i) > options_.max_descriptor_distance) continue;
      const auto keyframe = index_->keyframeOf.at(static_cast<std::size_t>(row));
      const bool mayVote = excluded.count(keyframe) == 0 && index_->removed.count(keyframe) == 0;
      if (mayVote && votedFor.insert(keyframe).second) ++votes[keyframe];
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
