#include "point_tracker.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

namespace wardslam::change {
namespace {

const cv::Size kWindow_px(9, 9);  // of the half-size image
constexpr int kLevels = 3;
constexpr int kNewApart_px = 10;  // from others, when a track starts
constexpr int kApart_px = 3;      // of two that come closer, one has slid
constexpr int kBorder_px = 12;    // half a window of the full image

std::vector<cv::Mat> pyramidOf(const cv::Mat& gray) {
  cv::Mat half;
  cv::resize(gray, half, {}, 0.5, 0.5, cv::INTER_AREA);
  std::vector<cv::Mat> pyramid;
  cv::buildOpticalFlowPyramid(half, pyramid, kWindow_px, kLevels);
  return pyramid;
}

// Pixel (0, 0) is the centre of the first pixel in both images.
cv::Point2f toHalf(const cv::Point2f& px) { return {(px.x - 0.5F) / 2, (px.y - 0.5F) / 2}; }
cv::Point2f toFull(const cv::Point2f& px) { return {px.x * 2 + 0.5F, px.y * 2 + 0.5F}; }

/// Moves `to` from its guess onto where `from` went. True where the way back leads to where it came from.
std::vector<bool> followThereAndBack(const std::vector<cv::Mat>& before, const std::vector<cv::Mat>& now,
                                     const std::vector<cv::Point2f>& from, std::vector<cv::Point2f>& to) {
  constexpr float kMostOff_px = 0.7F;
  const cv::TermCriteria enough(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 20, 0.02);
  const auto follow = [&](const auto& a, const auto& b, const auto& pointsA, auto& pointsB) {
    std::vector<std::uint8_t> found;
    cv::calcOpticalFlowPyrLK(a, b, pointsA, pointsB, found, cv::noArray(), kWindow_px, kLevels, enough,
                             cv::OPTFLOW_USE_INITIAL_FLOW, 1e-3);
    return found;
  };
  const auto there = follow(before, now, from, to);
  std::vector<cv::Point2f> again = from;
  const auto back = follow(now, before, to, again);
  std::vector<bool> isGood(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    const cv::Point2f off = again[i] - from[i];
    isGood[i] = there[i] != 0 && back[i] != 0 && std::hypot(off.x, off.y) < kMostOff_px;
  }
  return isGood;
}

bool isInside(const cv::Point2f& px, const cv::Size& size) {
  return px.x >= kBorder_px && px.y >= kBorder_px && px.x < static_cast<float>(size.width - kBorder_px) &&
         px.y < static_cast<float>(size.height - kBorder_px);
}

/// Keeps points apart.
class Occupancy {
 public:
  explicit Occupancy(const cv::Size& size) : isTaken_(size, CV_8UC1, cv::Scalar(0)) {}

  /// Whether no point within `radius_px` (square) was taken before; takes the place.
  [[nodiscard]] bool take(const cv::Point2f& px, int radius_px) {
    const cv::Point centre(cvRound(px.x), cvRound(px.y));
    if (isTaken_.at<std::uint8_t>(centre) != 0) return false;
    const cv::Rect around(centre.x - radius_px, centre.y - radius_px, 2 * radius_px + 1, 2 * radius_px + 1);
    isTaken_(around & cv::Rect({}, isTaken_.size())).setTo(1);
    return true;
  }

 private:
  cv::Mat isTaken_;
};

/// Between two images nothing comes or goes so fast: the patch slid over an edge onto something else.
bool slidOff(const Track& track, const core::DepthNoise& noise) {
  constexpr double kFastest_m = 0.12;  // per image
  const auto& [before, now] = std::pair(*(track.positions.end() - 2), track.positions.back());
  if (!before.hasDepth() || !now.hasDepth()) return false;
  return std::abs(now.depth.clear_m - before.depth.clear_m) > kFastest_m + 6 * noise.sigma_m(now.depth.clear_m);
}

void append(Track& track, const core::Frame& frame, std::uint64_t frameNumber, const cv::Point2f& undistorted_px) {
  TrackedPosition position;
  position.frame = frameNumber;
  position.undistorted_px = {static_cast<double>(undistorted_px.x), static_cast<double>(undistorted_px.y)};
  position.depth = depthAround(frame.depth_m, track.raw_px, frame.camera.depthNoise);
  if (!track.positions.empty()) {
    position.moved_px = (position.undistorted_px - track.positions.back().undistorted_px).norm();
  }
  track.positions.push_back(position);
}

/// Key points to start at: the strongest of each cell of the image, then the second strongest of each, and so on, so
/// that no part of it goes unwatched.
std::vector<const core::Keypoint*> bestOfEachCell(const core::Frame& frame) {
  constexpr int kCell_px = 80;
  std::vector<const core::Keypoint*> candidates;
  for (const core::Keypoint& keypoint : frame.features.keypoints) {
    if (isInside(keypoint.raw_px, frame.gray.size())) candidates.push_back(&keypoint);
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto* a, const auto* b) { return a->response > b->response; });
  cv::Mat taken(frame.gray.size() / kCell_px + cv::Size(1, 1), CV_32SC1, cv::Scalar(0));
  std::vector<std::pair<int, const core::Keypoint*>> ranked;
  for (const auto* keypoint : candidates) {
    ranked.emplace_back(taken.at<int>(cv::Point(keypoint->raw_px) / kCell_px)++, keypoint);
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::transform(ranked.begin(), ranked.end(), candidates.begin(), [](const auto& r) { return r.second; });
  return candidates;
}

}  // namespace

const TrackedPosition* Track::at(std::uint64_t frame) const {
  if (positions.empty() || frame < positions.front().frame || frame > positions.back().frame) return nullptr;
  return &positions[static_cast<std::size_t>(frame - positions.front().frame)];
}

DepthAround depthAround(const cv::Mat& depth_m, const cv::Point2f& raw_px, const core::DepthNoise& noise) {
  constexpr int kReach_px = PointTracker::kReach_px;
  constexpr int kStep_px = 2;
  const cv::Point centre(cvRound(raw_px.x), cvRound(raw_px.y));
  const cv::Rect inner(kReach_px, kReach_px, depth_m.cols - 2 * kReach_px, depth_m.rows - 2 * kReach_px);
  if (!inner.contains(centre)) return {};
  const auto z = static_cast<double>(depth_m.at<float>(centre));
  bool isClear = z > 0;
  DepthAround around;
  for (int dy = -kReach_px; dy <= kReach_px; dy += kStep_px) {
    for (int dx = -kReach_px; dx <= kReach_px; dx += kStep_px) {
      const auto other = static_cast<double>(depth_m.at<float>(centre + cv::Point(dx, dy)));
      if (other <= 0) continue;
      around.nearest_m = around.nearest_m > 0 ? std::min(around.nearest_m, other) : other;
      around.farthest_m = std::max(around.farthest_m, other);
      // A slanted surface changes with the distance; an edge does at once.
      const double jump_m = 0.02 + 0.004 * z * std::hypot(dx, dy) + 4 * noise.sigma_m(z);
      if (std::abs(other - z) > jump_m) isClear = false;
    }
  }
  if (isClear) around.clear_m = z;
  return around;
}

void PointTracker::follow(const core::Frame& frame, std::uint64_t frameNumber,
                          const std::vector<cv::Point2f>& predicted_px, std::uint64_t oldestFrame) {
  std::vector<cv::Mat> pyramid = pyramidOf(frame.gray);
  std::swap(pyramid, pyramid_);
  if (tracks_.empty() || pyramid.empty()) return;

  std::vector<cv::Point2f> from;
  std::vector<cv::Point2f> to;
  for (const Track& track : tracks_) from.push_back(toHalf(track.raw_px));
  for (const cv::Point2f& px : predicted_px) to.push_back(toHalf(px));
  const std::vector<bool> found = followThereAndBack(pyramid, pyramid_, from, to);

  std::vector<Track> followed;
  std::vector<cv::Point2f> raw_px;
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    const cv::Point2f px = toFull(to[i]);
    if (!found[i] || !isInside(px, frame.gray.size())) continue;
    raw_px.push_back(px);
    followed.push_back(std::move(tracks_[i]));
  }
  const auto undistorted_px = frame.camera.undistort(raw_px);
  Occupancy occupancy(frame.gray.size());
  tracks_.clear();
  for (std::size_t i = 0; i < followed.size(); ++i) {
    Track& track = followed[i];
    track.raw_px = raw_px[i];
    append(track, frame, frameNumber, undistorted_px[i]);
    while (track.positions.front().frame < oldestFrame) track.positions.pop_front();
    if (occupancy.take(track.raw_px, kApart_px) &&
        !(track.positions.size() > 1 && slidOff(track, frame.camera.depthNoise))) {
      tracks_.push_back(std::move(track));
    }
  }
}

void PointTracker::start(const core::Frame& frame, std::uint64_t frameNumber) {
  if (pyramid_.empty()) pyramid_ = pyramidOf(frame.gray);
  Occupancy occupancy(frame.gray.size());
  for (const Track& track : tracks_) static_cast<void>(occupancy.take(track.raw_px, kNewApart_px));

  for (const core::Keypoint* keypoint : bestOfEachCell(frame)) {
    if (tracks_.size() >= static_cast<std::size_t>(options_.points)) break;
    if (!occupancy.take(keypoint->raw_px, kNewApart_px)) continue;
    Track track;
    track.raw_px = keypoint->raw_px;
    append(track, frame, frameNumber, keypoint->undistorted_px);
    tracks_.push_back(std::move(track));
  }
}

}  // namespace wardslam::change
