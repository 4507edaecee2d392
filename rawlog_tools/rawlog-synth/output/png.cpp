#include "output/png.h"

#include <fstream>
#include <iomanip>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "wardslam/core/errors.h"

namespace wardslam::synth {
namespace {

Bytes encoded(const cv::Mat& image, const std::vector<int>& parameters) {
  Bytes bytes;
  if (!cv::imencode(".png", image, bytes, parameters)) throw core::InputError("an image cannot be coded as PNG");
  return bytes;
}

}  // namespace

/// OpenCV's own choice is the quickest: each byte as its difference to the one before it, and lengths of runs. Where a
/// degree of compression is asked for, all kinds of differences are tried in every row.
Bytes labelPng(const cv::Mat& image) { return encoded(image, {}); }

Bytes picturePng(const cv::Mat& image) { return encoded(image, {cv::IMWRITE_PNG_COMPRESSION, 1}); }

void writeBytes(const std::filesystem::path& file, const Bytes& bytes) {
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  out.flush();
  if (!out) throw core::InputError(file.string() + ": could not be written; is the disk full?");
}

std::string stampText(double stamp_s) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(6) << stamp_s;
  return text.str();
}

}  // namespace wardslam::synth
