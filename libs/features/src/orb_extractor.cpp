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

/// Of the depths measured around a pixel that has one, about its own.
float spreadAround(const cv::Mat& depth_m, const cv::Point& pixel) {
  const cv::Rect window = cv::Rect(pixel.x - 1, pixel.y - 1, 3, 3) & cv::Rect({}, depth_m.size());
  const float here_m = depth_m.at<float>(pixel);
  float squares_m2 = 0.0F;
  float measured = 0.0F;
  for (int y = window.y; y < window.br().y; ++y) {
    for (int x = window.x; x < window.br().x; ++x) {
      const float there_m = depth_m.at<float>(y, x);
      if (there_m <= 0.0F) continue;
      squares_m2 += (there_m - here_m) * (there_m - here_m);
      ++measured;
    }
  }
  return std::sqrt(squares_m2 / measured);
}

/// Nothing where there is no depth image.
void readDepth(const cv::Mat& depth_m, core::Keypoint& keypoint) {
  if (depth_m.empty()) return;
  const cv::Point pixel = core::nearestPixel(keypoint.raw_px, depth_m.size());
  keypoint.depth_m = depth_m.at<float>(pixel);
  if (keypoint.hasDepth()) keypoint.depthSpread_m = spreadAround(depth_m, pixel);
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
    readDepth(depth_m, keypoint);
    keypoint.angle_rad = chosen[i].angle * static_cast<float>(CV_PI / 180.0);
    keypoint.response = chosen[i].response;
    keypoint.scale = static_cast<float>(std::pow(options_.scale_factor, chosen[i].octave));
  }
  return features;
}

}  // namespace wardslam::features
