#include "picture_file.h"

#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "wardslam/core/atomic_file.h"

namespace wardslam::apps {

void writePng(const std::filesystem::path& file, const cv::Mat& picture) {
  std::vector<unsigned char> png;
  cv::imencode(".png", picture, png);
  core::writeFileAtomically(file, std::string(png.begin(), png.end()));
}

}  // namespace wardslam::apps
