#include "wardslam/odometry/matcher.h"

#include <cstring>
#include <limits>
#include <opencv2/core/hal/hal.hpp>
#include <opencv2/features2d.hpp>
#include <optional>

namespace wardslam::odometry {
namespace {

constexpr double kMaxScaleRatio = 1.5;  // two levels of ORB's pyramid and a bit

struct Candidate {
  std::size_t keypoint = 0;
  int distance = std::numeric_limits<int>::max();
};

bool isOfScale(const core::Keypoint& keypoint, double scale) {
  const double ratio = static_cast<double>(keypoint.scale) / scale;
  return ratio < kMaxScaleRatio && ratio > 1.0 / kMaxScaleRatio;
}

/// The most similar key point near the projection, if it is similar enough and clearly the best.
std::optional<Candidate> bestCandidate(const ProjectedPoint& point, const core::Features& features,
                                       const KeypointGrid& grid, double radius_px, const MatcherOptions& options) {
  Candidate best;
  Candidate second;
  grid.forEachNear(point.undistorted_px, radius_px * point.scale, [&](std::size_t index) {
    if (!isOfScale(features.keypoints[index], point.scale)) return;
    const auto* descriptor = features.descriptors.ptr(static_cast<int>(index));
    const int distance = cv::hal::normHamming(point.descriptor->data(), descriptor, sizeof(OrbDescriptor));
    if (distance < best.distance) {
      second = best;
      best = {index, distance};
    } else if (distance < second.distance) {
      second = {index, distance};
    }
  });
  if (best.distance > options.max_descriptor_distance) return std::nullopt;
  if (second.distance != std::numeric_limits<int>::max() && best.distance > options.max_ratio * second.distance) {
    return std::nullopt;
  }
  return best;
}

cv::Mat stackDescriptors(const std::vector<DescribedPoint>& points) {
  cv::Mat descriptors(static_cast<int>(points.size()), sizeof(OrbDescriptor), CV_8UC1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::memcpy(descriptors.ptr(static_cast<int>(i)), points[i].descriptor->data(), sizeof(OrbDescriptor));
  }
  return descriptors;
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
    if (candidate && candidate->distance < claims[candidate->keypoint].distance) {
      claims[candidate->keypoint] = {point.id, candidate->distance};
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
  const cv::BFMatcher bruteForce(cv::NORM_HAMMING);
  const cv::Mat pointDescriptors = stackDescriptors(points);
  std::vector<std::vector<cv::DMatch>> forward;
  std::vector<cv::DMatch> backward;
  bruteForce.knnMatch(pointDescriptors, features.descriptors, forward, 2);
  bruteForce.match(features.descriptors, pointDescriptors, backward);

  std::vector<Match> matches;
  for (const auto& best : forward) {
    const bool isSimilar = static_cast<double>(best[0].distance) <= options_.max_descriptor_distance;
    const bool isClear =
        static_cast<double>(best[0].distance) <= options_.max_ratio * static_cast<double>(best[1].distance);
    const bool isMutual = backward[static_cast<std::size_t>(best[0].trainIdx)].trainIdx == best[0].queryIdx;
    if (isSimilar && isClear && isMutual) {
      matches.push_back(
          {points[static_cast<std::size_t>(best[0].queryIdx)].id, static_cast<std::size_t>(best[0].trainIdx)});
    }
  }
  return matches;
}

}  // namespace wardslam::odometry
