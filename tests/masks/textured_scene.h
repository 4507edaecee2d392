#pragma once

#include <opencv2/imgproc.hpp>

#include "wardslam/core/segmentation.h"

/// Pictures of things made by hand: what is where, and how far away, is known to the pixel.
namespace wardslam::masks::scene {

inline constexpr int kWidth_px = 320;
inline constexpr int kHeight_px = 240;
inline constexpr core::ClassId kPerson = 1;
inline constexpr core::ClassId kChair = 57;

/// Smooth enough to be followed over a few pixels, different for every seed.
inline cv::Mat texture(std::uint64_t seed, cv::Size size = {kWidth_px, kHeight_px}) {
  cv::RNG random(seed);
  cv::Mat image(size, CV_8UC1);
  random.fill(image, cv::RNG::UNIFORM, 0, 256);
  cv::GaussianBlur(image, image, {}, 2.0);
  cv::normalize(image, image, 20, 235, cv::NORM_MINMAX);
  return image;
}

/// A picture with its depth and its true masks.
struct Picture {
  cv::Mat gray;
  cv::Mat depth_m;
  core::Segmentation masks;
};

/// A wall, seen through an image that has moved along it by `origin_px`.
inline Picture wall(double depth_m, cv::Point origin_px = {}) {
  constexpr int kBorder_px = 100;
  const cv::Mat all = texture(1, {kWidth_px + 2 * kBorder_px, kHeight_px + 2 * kBorder_px});
  const cv::Rect view(kBorder_px + origin_px.x, kBorder_px + origin_px.y, kWidth_px, kHeight_px);
  const cv::Size size(kWidth_px, kHeight_px);
  return {all(view).clone(),
          cv::Mat(size, CV_32FC1, cv::Scalar(depth_m)),
          {cv::Mat(size, CV_8UC1, cv::Scalar(0)), cv::Mat(size, CV_16UC1, cv::Scalar(0)), {}}};
}

/// Puts a thing before it, which takes its texture along; parts outside the image are cut.
inline void put(Picture& picture, std::uint16_t id, core::ClassId classId, cv::Rect box, double depth_m) {
  const cv::Rect seen = box & cv::Rect({}, picture.gray.size());
  if (seen.empty()) return;
  texture(100U + id, box.size())(seen - box.tl()).copyTo(picture.gray(seen));
  picture.depth_m(seen).setTo(depth_m);
  picture.masks.classIds(seen).setTo(classId);
  picture.masks.instanceIds(seen).setTo(id);
  picture.masks.instances.push_back({id, classId, 0.9F, seen});
}

/// Share of the pixels of either that both have (intersection over union).
inline double iou(const cv::Mat& a, const cv::Mat& b) {
  const int united = cv::countNonZero(a | b);
  return united == 0 ? 1.0 : static_cast<double>(cv::countNonZero(a & b)) / united;
}

}  // namespace wardslam::masks::scene
