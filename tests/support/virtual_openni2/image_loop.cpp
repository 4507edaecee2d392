#include "image_loop.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace wardslam::test {

ImageLoop::ImageLoop(const std::filesystem::path& folder) : folder_(folder), pairs_(sources::listImagePairs(folder)) {}

ImageLoop::Images ImageLoop::at(std::uint64_t index, cv::Size size) const {
  Images images{cv::Mat::zeros(size, CV_8UC3), cv::Mat::zeros(size, CV_16UC1)};
  const std::uint64_t last = pairs_.size() - 1;
  const std::uint64_t phase = last == 0 ? 0 : index % (2 * last);
  const auto& pair = pairs_[phase <= last ? phase : 2 * last - phase];

  const cv::Mat color = cv::imread((folder_ / pair.color.file).string(), cv::IMREAD_COLOR);
  const cv::Mat depth = cv::imread((folder_ / pair.depth.file).string(), cv::IMREAD_UNCHANGED);
  if (color.empty() || depth.empty()) return images;
  cv::cvtColor(color, images.color_rgb, cv::COLOR_BGR2RGB);
  constexpr double kUnitsPer_mm = 5.0;
  depth.convertTo(images.depth_mm, CV_16U, 1.0 / kUnitsPer_mm);
  if (color.size() != size) {
    cv::resize(images.color_rgb, images.color_rgb, size, 0, 0, cv::INTER_AREA);
    cv::resize(images.depth_mm, images.depth_mm, size, 0, 0, cv::INTER_NEAREST);
  }
  return images;
}

}  // namespace wardslam::test
