#include "wardslam/features/orb_extractor.h"

#include <cmath>
#include <opencv2/features2d.hpp>

#include "even_spread.h"
#include "wardslam/core/nearest_pixel.h"

namespace wardslam::features {
namespace {

constexpr int kPatchSize_px = 31;

cv::Ptr<cv::ORB> makeOrb(const OrbOptions& options) {
  return cv::ORB::create(options.key_points * options.oversampling, static_cast<float>(options.scale_factor),
                         options.levels, kPatchSize_px / 2 + 1, 0, 2, cv::ORB::HARRIS_SCORE, kPatchSize_px,
                         options.fast_threshold);
}

/// Level l of an n-level pyramid gets a share proportional to its side length, as ORB itself does it.
std::vector<std::size_t> shareOfLevels(const OrbOptions& options) {
  const double q = 1.0 / options.scale_factor;
  const double first = options.key_points * (1.0 - q) / (1.0 - std::pow(q, options.levels));
  std::vector<std::size_t> shares;
  for (int level = 0; level < options.levels; ++level) {
    shares.push_back(static_cast<std::size_t>(std::lround(first * std::pow(q, level))));
  }
  return shares;
}

std::vector<cv::KeyPoint> chooseEvenly(const std::vector<cv::KeyPoint>& candidates, const OrbOptions& options) {
  std::vector<std::vector<cv::KeyPoint>> byLevel(static_cast<std::size_t>(options.levels));
  for (const auto& candidate : candidates) byLevel[static_cast<std::size_t>(candidate.octave)].push_back(candidate);

  const auto shares = shareOfLevels(options);
  std::vector<cv::KeyPoint> chosen;
  for (std::size_t level = 0; level < byLevel.size(); ++level) {
    const double scale = std::pow(options.scale_factor, static_cast<double>(level));
    const int cell_px = static_cast<int>(std::lround(options.cell_size_px * scale));
    const auto spread = spreadEvenly(std::move(byLevel[level]), shares[level], cell_px);
    chosen.insert(chosen.end(), spread.begin(), spread.end());
  }
  return chosen;
}

float depthAt(const cv::Mat& depth_m, const cv::Point2f& raw_px) {
  if (depth_m.empty()) return 0.0F;
  return depth_m.at<float>(core::nearestPixel(raw_px, depth_m.size()));
}

}  // namespace

OrbExtractor::OrbExtractor(const OrbOptions& options) : options_(options) {}

core::Features OrbExtractor::extract(const cv::Mat& gray, const cv::Mat& depth_m,
                                     const core::CameraModel& camera) const {
  const auto orb = makeOrb(options_);
  std::vector<cv::KeyPoint> candidates;
  orb->detect(gray, candidates);
  auto chosen = chooseEvenly(candidates, options_);

  core::Features features;
  orb->compute(gray, chosen, features.descriptors);

  std::vector<cv::Point2f> raw_px;
  cv::KeyPoint::convert(chosen, raw_px);
  const auto undistorted_px = camera.undistort(raw_px);
  features.keypoints.resize(chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    core::Keypoint& keypoint = features.keypoints[i];
    keypoint.raw_px = raw_px[i];
    keypoint.undistorted_px = undistorted_px[i];
    keypoint.depth_m = depthAt(depth_m, raw_px[i]);
    keypoint.angle_rad = chosen[i].angle * static_cast<float>(CV_PI / 180.0);
    keypoint.response = chosen[i].response;
    keypoint.scale = static_cast<float>(std::pow(options_.scale_factor, chosen[i].octave));
  }
  return features;
}

}  // namespace wardslam::features
