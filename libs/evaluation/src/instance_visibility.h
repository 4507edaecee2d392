#pragma once

#include <filesystem>
#include <map>

namespace wardslam::evaluation {

/// How well a thing was seen in a recording.
struct Visibility {
  int frames = 0;     ///< Images that show any of it.
  int maxPixels = 0;  ///< In the image that shows most of it.
};

/// By instance id, counted in a folder of images (16 bit, one channel) of instance ids. Throws core::InputError naming
/// what is no such image, or the folder where it holds none.
[[nodiscard]] std::map<int, Visibility> countVisibility(const std::filesystem::path& instances);

}  // namespace wardslam::evaluation
