#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>

namespace wardslam::segmentation {

/// A mask as some program saved it, as class numbers.
struct MaskFile {
  cv::Mat values;        ///< CV_8UC1; empty where the file cannot be used.
  std::string trouble;   ///< Why not, a sentence that begins with the file.
  std::string encoding;  ///< What had to be done to get at the numbers, a sentence part; empty: nothing.
};

/// Grey PNGs of 1 to 16 bits, palettes (their indices) and colour pictures of three equal channels.
[[nodiscard]] MaskFile readMaskFile(const std::filesystem::path& file);

/// The file decoded as it is, CV_8U or CV_16U with any number of channels; empty where it is missing or damaged.
[[nodiscard]] cv::Mat readUnchanged(const std::filesystem::path& file);

}  // namespace wardslam::segmentation
