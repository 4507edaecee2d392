#include "instance_visibility.h"

#include <algorithm>
#include <cstdint>
#include <opencv2/imgcodecs.hpp>

#include "wardslam/core/errors.h"

namespace wardslam::evaluation {
namespace {

namespace fs = std::filesystem;

std::map<int, int> countPixels(const fs::path& file) {
  const cv::Mat ids = cv::imread(file.string(), cv::IMREAD_UNCHANGED);
  if (ids.type() != CV_16UC1) {
    throw core::InputError(file.string() + ": is no image of instance ids with 16 bits; render the labels again");
  }
  std::map<int, int> pixels;
  for (int row = 0; row < ids.rows; ++row) {
    const auto* const id = ids.ptr<std::uint16_t>(row);
    for (int column = 0; column < ids.cols; ++column) ++pixels[id[column]];
  }
  return pixels;
}

}  // namespace

std::map<int, Visibility> countVisibility(const fs::path& instances) {
  std::map<int, Visibility> all;
  std::error_code error;
  bool isEmpty = true;
  for (const auto& file : fs::directory_iterator(instances, error)) {
    if (file.path().extension() != ".png") continue;
    isEmpty = false;
    for (const auto& [id, pixels] : countPixels(file.path())) {
      ++all[id].frames;
      all[id].maxPixels = std::max(all[id].maxPixels, pixels);
    }
  }
  if (isEmpty) throw core::InputError(instances.string() + ": holds no image of instances (.png)");
  return all;
}

}  // namespace wardslam::evaluation
