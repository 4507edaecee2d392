#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <vector>

#include "wardslam/sources/tum_lists.h"

namespace wardslam::test {

/// The images of a TUM folder to and fro without end, so that the camera never jumps.
class ImageLoop {
 public:
  struct Images {
    cv::Mat color_rgb;  ///< CV_8UC3
    cv::Mat depth_mm;   ///< CV_16UC1
  };

  /// Throws core::InputError where there are no lists of images.
  explicit ImageLoop(const std::filesystem::path& folder);

  /// The images number `index` of the endless sequence; black ones where they cannot be read.
  [[nodiscard]] Images at(std::uint64_t index, cv::Size size) const;

 private:
  std::filesystem::path folder_;
  std::vector<sources::ImagePair> pairs_;
};

}  // namespace wardslam::test
