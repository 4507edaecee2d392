#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

#include "wardslam/bags/byte_view.h"

namespace wardslam::bags {

/// Depth (m) as ROS's package compressed_depth_image_transport quantises it: a / (value − b); 0 where the value is 0,
/// or what comes out is no positive number. CV_16UC1 in, CV_32FC1 out.
[[nodiscard]] cv::Mat depthOfInverse(const cv::Mat& inverse, float a, float b);

/// Unpacks depth packed by A. Wilson's "Fast lossless depth image compression" (ISS 2017), preceded by width and height
/// (32 bits each), as compressed_depth_image_transport writes it. CV_16UC1. Throws BagDamage.
[[nodiscard]] cv::Mat decodeRvl(ByteView packed);

}  // namespace wardslam::bags
