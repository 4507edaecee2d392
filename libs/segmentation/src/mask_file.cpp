#include "mask_file.h"

#include <fstream>
#include <iterator>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "raw_png.h"
#include "wardslam/core/image_header.h"

namespace wardslam::segmentation {
namespace {

namespace fs = std::filesystem;

std::vector<char> readBytes(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

bool isTooLarge(const std::vector<char>& bytes) {
  return core::imageHeader(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()).isTooLarge();
}

// Without what cv::imread would print where a file is missing.
cv::Mat decode(const std::vector<char>& bytes) {
  if (bytes.empty() || isTooLarge(bytes)) return {};
  try {
    return cv::imdecode(bytes, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    return {};
  }
}

MaskFile refused(const fs::path& file, const std::string& what) { return {{}, file.string() + ": " + what, {}}; }

constexpr const char* kSaveIds = "save class ids as grey values of an 8-bit single-channel PNG, 0 where there is none";

/// The first channel where all that show colour are equal; empty else.
cv::Mat equalChannel(const cv::Mat& image) {
  std::vector<cv::Mat> channels;
  cv::split(image, channels);
  const std::size_t colors = channels.size() == 2 || channels.size() == 4 ? channels.size() - 1 : channels.size();
  for (std::size_t c = 1; c < colors; ++c) {
    if (cv::norm(channels[0], channels[c], cv::NORM_INF) != 0.0) return {};
  }
  return channels[0];
}

std::string encodingOf(const RawPng& png) {
  if (png.kind == RawPng::Kind::Palette) return "are pictures with a palette, whose indices are taken for class ids";
  if (png.kind != RawPng::Kind::Gray || png.bits == 8) return {};
  return "have " + std::to_string(png.bits) + (png.bits == 1 ? " bit" : " bits") +
         " a pixel, which are taken for class ids as they are stored";
}

}  // namespace

cv::Mat readUnchanged(const fs::path& file) { return decode(readBytes(file)); }

MaskFile readMaskFile(const fs::path& file) {
  const auto bytes = readBytes(file);
  if (isTooLarge(bytes)) return refused(file, "claims to be larger than the image of any camera; leave it out");
  const RawPng png = readRawPng(bytes);
  MaskFile mask;
  mask.values = png.values;
  mask.encoding = encodingOf(png);
  if (mask.values.empty()) {
    const cv::Mat decoded = decode(bytes);
    if (decoded.empty()) return refused(file, "damaged or not a PNG; write the masks anew or leave this one out");
    mask.values = decoded.channels() == 1 ? decoded : equalChannel(decoded);
    if (decoded.channels() > 1) mask.encoding = "have three equal channels, one of which is taken for class ids";
    if (mask.values.empty()) return refused(file, std::string("is a picture in colours, not class ids; ") + kSaveIds);
  }
  if (mask.values.depth() == CV_8U) return mask;
  double largest = 0.0;
  cv::minMaxLoc(mask.values, nullptr, &largest);
  if (mask.values.depth() != CV_16U)
    return refused(file, std::string("is not of whole numbers of 8 or 16 bits; ") + kSaveIds);
  if (largest > 255.0) {
    return refused(file, "holds the number " + std::to_string(static_cast<int>(largest)) +
                             ", but class ids go to 255; " + kSaveIds);
  }
  cv::Mat eightBit;
  mask.values.convertTo(eightBit, CV_8U);
  mask.values = eightBit;
  return mask;
}

}  // namespace wardslam::segmentation
