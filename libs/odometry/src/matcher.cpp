#include "wardslam/odometry/matcher.h"

#include <limits>
#include <opencv2/core/hal/hal.hpp>
#include <optional>

#include "wardslam/odometry/descriptor_words.h"

namespace wardslam::odometry {
namespace {

constexpr double kMaxScaleRatio = 1.5;  // two levels of ORB's pyramid and a bit

/// The nearest of many, of equals the first, and how far the next one is.
struct Nearest {
  std::size_t index = 0;
  int distance = std::numeric_limits<int>::max();
  int nextDistance = std::numeric_limits<int>::max();

  void consider(std::size_t other, int otherDistance) {
    if (otherDistance < distance) {
      nextDistance = distance;
      distance = otherDistance;
      index = other;
    } else if (otherDistance < nextDistance) {
      nextDistance = otherDistance;
    }
  }
};

bool isOfScale(const core::Keypoint& keypoint, double scale) {
  const double ratio = static_cast<double>(keypoint.scale) / scale;
  return ratio < kMaxScaleRatio && ratio > 1.0 / kMaxScaleRatio;
}

/// The most similar key point near the projection, if it is similar enough and clearly the best.
std::optional<Nearest> bestCandidate(const ProjectedPoint& point, const core::Features& features,
                                     const KeypointGrid& grid, double radius_px, const MatcherOptions& options) {
  Nearest best;
  grid.forEachNear(point.undistorted_px, radius_px * point.scale, [&](std::size_t index) {
    if (!isOfScale(features.keypoints[index], point.scale)) return;
    const auto* descriptor = features.descriptors.ptr(static_cast<int>(index));
    best.consider(index, cv::hal::normHamming(point.descriptor->data(), descriptor, sizeof(OrbDescriptor)));
  });
  if (best.distance > options.max_descriptor_distance) return std::nullopt;
  const bool isAlone = best.nextDistance == std::numeric_limits<int>::max();
  if (!isAlone && best.distance > options.max_ratio * best.nextDistance) {
    return std::nullopt;
  }
  return best;
}

}  // namespace

std::vector<Match> Matcher::searchNear(const std::vector<ProjectedPoint>& points, const core::Features& features,
                                       const KeypointGrid& grid, double radius_px) const {
  struct Claim {
    PointId point = 0;
    int distance = std::numeric_limits<int>::max();
  };
  std::vector<Claim> claims(features.size());
  for (const ProjectedPoint& point : points) {
    const auto candidate = bestCandidate(point, features, grid, radius_px, options_);
    if (candidate && candidate->distance < claims[candidate->index].distance) {
      claims[candidate->index] = {point.id, candidate->distance};
    }
  }
  std::vector<Match> matches;
  for (std::size_t keypoint = 0; keypoint < claims.size(); ++keypoint) {
    if (claims[keypoint].point != 0) matches.push_back({claims[keypoint].point, keypoint});
  }
  return matches;
}

std::vector<Match> Matcher::searchEverywhere(const std::vector<DescribedPoint>& points,
                                             const core::Features& features) const {
  if (points.empty() || features.size() < 2) return {};
  std::vector<DescriptorWords> words;
  for (std::size_t i = 0; i < features.size(); ++i) {
    words.push_back(wordsOf(features.descriptors.ptr(static_cast<int>(i))));
  }
  std::vector<Nearest> toPoint(points.size());
  std::vector<Nearest> toKeypoint(features.size());
  for (std::size_t point = 0; point < points.size(); ++point) {
    const DescriptorWords look = wordsOf(points[point].descriptor->data());
    for (std::size_t keypoint = 0; keypoint < words.size(); ++keypoint) {
      const int distance = differingBits(look, words[keypoint]);
      toPoint[point].consider(keypoint, distance);
      toKeypoint[keypoint].consider(point, distance);
    }
  }
  std::vector<Match> matches;
  for (std::size_t point = 0; point < points.size(); ++point) {
    const Nearest& best = toPoint[point];
    const bool isSimilar = best.distance <= options_.max_descriptor_distance;
    const bool isClear = best.distance <= options_.max_ratio * best.nextDistance;
    if (isSimilar && isClear && toKeypoint[best.index].index == point)
      matches.push_back({points[point].id, best.index});
  }
  return matches;
}

}  // namespace wardslam::odometry
