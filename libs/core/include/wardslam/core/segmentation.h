#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace wardslam::core {

using ClassId = std::uint8_t;  ///< 0 = unclassified (c0 in Eq. 1), otherwise an id of the LabelSpace in use.

/// One segmented thing in one image.
struct Instance {
  std::uint16_t id = 0;  ///< The value of its pixels in Segmentation::instanceIds; > 0, unique in the image.
  ClassId classId = 0;
  float confidence = 1.0F;  ///< 0..1
  cv::Rect box_px;          ///< Bounding box in the raw image.
};

/// What the picture shows, per pixel and per thing (P3). Images have the size of the colour image, raw
/// (not undistorted) pixels.
struct Segmentation {
  cv::Mat classIds;     ///< CV_8UC1, ClassId per pixel; empty = not segmented.
  cv::Mat instanceIds;  ///< CV_16UC1, Instance::id per pixel, 0 = none.
  std::vector<Instance> instances;

  [[nodiscard]] bool empty() const { return classIds.empty(); }
};

}  // namespace wardslam::core
