#pragma once

#include <filesystem>
#include <opencv2/core.hpp>

namespace wardslam::apps {

/// A picture (CV_8UC3, BGR) as PNG; complete or not there. Throws core::InputError when the disk does not take it.
void writePng(const std::filesystem::path& file, const cv::Mat& picture);

}  // namespace wardslam::apps
