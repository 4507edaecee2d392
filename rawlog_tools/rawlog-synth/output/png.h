#pragma once

#include <filesystem>
#include <opencv2/core.hpp>

#include "output/recording.h"

namespace wardslam::synth {

/// PNG of a label image: run-length matching is what suits it, and it is fast.
[[nodiscard]] Bytes labelPng(const cv::Mat& image);
/// PNG of a photograph or of depths: little effort, as recordings are large and soon read.
[[nodiscard]] Bytes picturePng(const cv::Mat& image);

/// Throws core::InputError when the disk does not take it.
void writeBytes(const std::filesystem::path& file, const Bytes& bytes);

/// "1700000000.033333", as stamps and files are named.
[[nodiscard]] std::string stampText(double stamp_s);

}  // namespace wardslam::synth
