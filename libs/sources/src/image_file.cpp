#include "image_file.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "wardslam/core/image_header.h"
#include "wardslam/sources/input_damage.h"

namespace wardslam::sources {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::array<std::uint8_t, 8> kPngSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::array<std::uint8_t, 4> kPngEnd = {'I', 'E', 'N', 'D'};  // type of the last chunk
constexpr std::array<std::uint8_t, 2> kJpegStart = {0xFF, 0xD8};
constexpr std::array<std::uint8_t, 2> kJpegEnd = {0xFF, 0xD9};  // cannot occur within entropy-coded data
constexpr std::size_t kPngBitDepthOffset = 24;                  // signature, length, "IHDR", width, height

/// Some writers pad the file behind its end marker.
constexpr std::size_t kTail_bytes = 1024;

template <std::size_t N>
bool startsWith(const Bytes& bytes, const std::array<std::uint8_t, N>& mark) {
  return bytes.size() >= N && std::equal(mark.begin(), mark.end(), bytes.begin());
}

template <std::size_t N>
bool endsWithin(const Bytes& bytes, const std::array<std::uint8_t, N>& mark) {
  const auto tail = bytes.end() - static_cast<std::ptrdiff_t>(std::min(bytes.size(), kTail_bytes));
  return std::search(tail, bytes.end(), mark.begin(), mark.end()) != bytes.end();
}

bool isCutOff(const Bytes& bytes) {
  if (startsWith(bytes, kPngSignature)) return !endsWithin(bytes, kPngEnd);
  if (startsWith(bytes, kJpegStart)) return !endsWithin(bytes, kJpegEnd);
  return false;
}

Bytes readCompleteFile(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  if (!in || !std::filesystem::is_regular_file(file)) {
    throw InputDamage("sources.image_missing", file.string() + " is missing");
  }
  Bytes bytes(static_cast<std::size_t>(in.tellg()));
  in.seekg(0);
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!in || bytes.empty() || isCutOff(bytes)) {
    throw InputDamage("sources.image_truncated", file.string() + " is cut off before the end of the image");
  }
  return bytes;
}

cv::Mat decode(const std::filesystem::path& file, int flags) {
  const Bytes bytes = readCompleteFile(file);
  const core::ImageHeader header = core::imageHeader(bytes.data(), bytes.size());
  if (header.isTooLarge()) {
    throw InputDamage("sources.image_unreadable", file.string() + " claims to be an image of " +
                                                      std::to_string(header.width_px) + "x" +
                                                      std::to_string(header.height_px) + " pixels");
  }
  cv::Mat image;
  try {
    image = cv::imdecode(bytes, flags | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception&) {
    image.release();  // reported below
  }
  if (image.empty()) {
    throw InputDamage("sources.image_unreadable",
                      file.string() + " cannot be decoded as an image (PNG, JPEG, TIFF, BMP, WebP, EXR and PFM can)");
  }
  return image;
}

}  // namespace

cv::Mat readColorImage(const std::filesystem::path& file) { return decode(file, cv::IMREAD_COLOR); }

cv::Mat readDepthImage(const std::filesystem::path& file) {
  cv::Mat depth = decode(file, cv::IMREAD_ANYDEPTH | cv::IMREAD_ANYCOLOR);
  if (depth.type() == CV_32FC3) cv::extractChannel(depth, depth, 0);  // EXR of one channel, given as grey
  if (depth.type() == CV_16UC1 || depth.type() == CV_32FC1) return depth;
  const std::string why = depth.depth() == CV_8U
                              ? " has 8 bits a pixel, in which the metres are lost; export depth as PNG of one 16-bit "
                                "channel"
                              : " has " + std::to_string(depth.channels()) + " channels";
  throw InputDamage("sources.depth_format", file.string() + " is not a depth image of one 16-bit channel:" + why);
}

bool isFloatImageName(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  return extension == ".exr" || extension == ".tiff" || extension == ".tif" || extension == ".pfm";
}

void requireCompleteImage(const std::filesystem::path& file) { readCompleteFile(file); }

bool isSixteenBitPng(const std::filesystem::path& file) {
  Bytes head(kPngBitDepthOffset + 1);
  std::ifstream in(file, std::ios::binary);
  in.read(reinterpret_cast<char*>(head.data()), static_cast<std::streamsize>(head.size()));
  return in && startsWith(head, kPngSignature) && head[kPngBitDepthOffset] == 16;
}

}  // namespace wardslam::sources
