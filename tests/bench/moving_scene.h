#pragma once

#include <cstdint>
#include <opencv2/imgproc.hpp>

#include "wardslam/core/segmentation.h"

/// What the benchmarks look at: something in which everything moves, without a recording.
namespace wardslam::bench {

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr int kWallShift_px = 6;  ///< To the right, from moment to moment.

struct Scene {
  cv::Mat gray;
  cv::Mat depth_m;
  core::Segmentation masks;
};

inline cv::Mat texture(std::uint64_t seed) {
  cv::RNG random(seed);
  cv::Mat image(kHeight, kWidth, CV_8UC1);
  random.fill(image, cv::RNG::UNIFORM, 0, 256);
  cv::GaussianBlur(image, image, {}, 2.5);
  cv::normalize(image, image, 20, 235, cv::NORM_MINMAX);
  return image;
}

inline cv::Mat shifted(const cv::Mat& image, int x_px) {
  cv::Mat result;
  cv::warpAffine(image, result, cv::Matx23d(1, 0, x_px, 0, 1, 0), image.size(), cv::INTER_NEAREST, cv::BORDER_WRAP);
  return result;
}

/// A textured wall 4 m away, with people and chairs in turn, of random texture, at 1.5 to 3 m before it. From moment to
/// moment the wall shifts as when the camera turns, the others twice as far.
inline Scene sceneAt(int moment, int instances) {
  Scene scene{shifted(texture(1), kWallShift_px * moment),
              cv::Mat(kHeight, kWidth, CV_32FC1, cv::Scalar(4.0)),
              {cv::Mat::zeros(kHeight, kWidth, CV_8UC1), cv::Mat::zeros(kHeight, kWidth, CV_16UC1), {}}};
  for (int i = 0; i < instances; ++i) {
    const cv::Point centre((i * 140 + 90 + 2 * kWallShift_px * moment) % kWidth, 160 + 80 * (i % 3));
    cv::Mat shape(kHeight, kWidth, CV_8UC1, cv::Scalar(0));
    cv::ellipse(shape, centre, {35 + 3 * i, 90}, 0, 0, 360, 255, cv::FILLED);
    shifted(texture(static_cast<std::uint64_t>(i) + 2), 2 * kWallShift_px * moment).copyTo(scene.gray, shape);
    scene.depth_m.setTo(1.5 + 0.15 * i, shape);
    const auto classId = static_cast<core::ClassId>(i % 2 == 0 ? 1 : 57);
    scene.masks.classIds.setTo(classId, shape);
    scene.masks.instanceIds.setTo(i + 1, shape);
    scene.masks.instances.push_back({static_cast<std::uint16_t>(i + 1), classId, 0.9F, cv::boundingRect(shape)});
  }
  return scene;
}

}  // namespace wardslam::bench
