#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace wardslam::segmentation {

/// A PNG with its numbers as they are stored.
struct RawPng {
  enum class Kind : std::uint8_t { Gray, Palette, Other };

  Kind kind = Kind::Other;
  int bits = 0;    ///< Of a number in the file: 1, 2, 4, 8 or 16.
  cv::Mat values;  ///< CV_8UC1 or CV_16UC1; palette: the indices. Empty for colour pictures.
};

/// Decoders made for pictures spread the numbers of 1, 2 and 4 bits over 0..255 and put colours in place of a palette's
/// indices; in masks the numbers count. Kind::Other, without values, for what is no PNG of one channel, is damaged, or
/// is interlaced.
[[nodiscard]] RawPng readRawPng(const std::vector<char>& bytes);

}  // namespace wardslam::segmentation
