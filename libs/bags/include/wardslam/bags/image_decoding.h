#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <string>

#include "wardslam/bags/messages.h"

namespace wardslam::bags {

/// Encodings of sensor_msgs/Image that are colour (or grey) images: rgb8, bgr8, rgba8, bgra8, mono8, 8UC1, 8UC3.
[[nodiscard]] bool isColorEncoding(const std::string& encoding);

/// Those that are depth: 16UC1 and mono16 in millimetres, 32FC1 in metres (REP 118).
[[nodiscard]] bool isDepthEncoding(const std::string& encoding);

/// The depth image of image_transport's "compressedDepth", by the format of the message.
[[nodiscard]] bool isCompressedDepth(const std::string& format);

/// CV_8UC3 (BGR; 8UC3 is taken for that) or CV_8UC1, with data of its own. Throws BagDamage.
[[nodiscard]] cv::Mat decodeColor(const Image& image);
[[nodiscard]] cv::Mat decodeColor(const CompressedImage& image);

struct DepthImage {
  cv::Mat units;  ///< CV_16UC1; 0: nothing measured.
  double unit_m = 0.001;
  bool isOfMetres = false;  ///< 32FC1: nobody but decodeDepth() chose the unit.
  std::size_t tooFar = 0;   ///< Pixels whose depth (32FC1) has no place in 16 bits of this unit, and are 0.
};

/// Depth in metres (32FC1) is given in steps of 0.2 mm, as in recordings of the TUM benchmark. Throws BagDamage.
[[nodiscard]] DepthImage decodeDepth(const Image& image);
[[nodiscard]] DepthImage decodeDepth(const CompressedImage& image);

}  // namespace wardslam::bags
