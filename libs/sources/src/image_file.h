#pragma once

#include <filesystem>
#include <opencv2/core.hpp>

namespace wardslam::sources {

/// The colour image, CV_8UC3, BGR; a monochrome file gives three equal channels. Throws InputDamage.
[[nodiscard]] cv::Mat readColorImage(const std::filesystem::path& file);

/// The depth image: CV_16UC1 in the file's units, or CV_32FC1 (EXR, TIFF, PFM) in metres. Throws InputDamage.
[[nodiscard]] cv::Mat readDepthImage(const std::filesystem::path& file);

/// Whether a depth image of this name holds metres as floating-point numbers.
[[nodiscard]] bool isFloatImageName(const std::filesystem::path& file);

/// Throws InputDamage where the file is missing or is a PNG or JPEG that was cut off. Decoders may pass such a file
/// as an image that is partly black.
void requireCompleteImage(const std::filesystem::path& file);

[[nodiscard]] bool isSixteenBitPng(const std::filesystem::path& file);

}  // namespace wardslam::sources
