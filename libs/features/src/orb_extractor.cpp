#include "wardslam/features/orb_extractor.h"

#include <cmath>
#include <opencv2/features2d.hpp>

#include "even_spread.h"
#include "orb_corners.h"
#include "wardslam/core/nearest_pixel.h"

namespace wardslam::features {
namespace {

cv::Ptr<cv::ORB> makeDescriber(const OrbOptions& options) {
  return cv::ORB::create(options.key_points, static_cast<float>(options.scale_factor), options.levels,
                         kOrbPatch_px / 2 + 1, 0, 2, cv::ORB::FAST_SCORE, kOrbPatch_px, options.fast_threshold);
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

/// Corners of one copy of the image, in pixels of the image, evenly spread. Only what is chosen gets a direction.
std::vector<cv::KeyPoint> chooseEvenly(const cv::Mat& copy, int level, std::size_t share, const OrbOptions& options) {
  const double scale = std::pow(options.scale_factor, level);
  const std::size_t candidates = share * static_cast<std::size_t>(options.oversampling);
  auto corners = strongestCorners(copy, options.fast_threshold, candidates);
  for (cv::KeyPoint& corner : corners) corner.pt *= static_cast<float>(scale);
  auto chosen = spreadEvenly(std::move(corners), share, static_cast<int>(std::lround(options.cell_size_px * scale)));
  for (cv::KeyPoint& corner : chosen) {
    corner.angle = centroidAngle_deg(copy, corner.pt / static_cast<float>(scale));
    corner.octave = level;
    corner.size = kOrbPatch_px * static_cast<float>(scale);
  }
  return chosen;
}

std::vector<cv::KeyPoint> findKeypoints(const cv::Mat& gray, const OrbOptions& options) {
  const auto pyramid = orbPyramid(gray, options.scale_factor, options.levels);
  const auto shares = shareOfLevels(options);
  std::vector<cv::KeyPoint> keypoints;
  for (std::size_t level = 0; level < pyramid.size(); ++level) {
    const auto chosen = chooseEvenly(pyramid[level], static_cast<int>(level), shares[level], options);
    keypoints.insert(keypoints.end(), chosen.begin(), chosen.end());
  }
  return keypoints;
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
  auto chosen = findKeypoints(gray, options_);

  core::Features features;
  makeDescriber(options_)->compute(gray, chosen, features.descriptors);

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
