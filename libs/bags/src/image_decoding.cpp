#include "wardslam/bags/image_decoding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "byte_cursor.h"
#include "compressed_depth.h"
#include "wardslam/core/image_header.h"

namespace wardslam::bags {
namespace {

constexpr double kStepOfMetres_m = 0.0002;
constexpr double kMillimetre_m = 0.001;
constexpr std::size_t kDepthHeader_bytes = 12;

struct ColorEncoding {
  const char* name;
  int channels;
  int toBgr;  ///< For cv::cvtColor; -1: as it is.
};
constexpr std::array<ColorEncoding, 7> kColorEncodings = {{{"rgb8", 3, cv::COLOR_RGB2BGR},
                                                           {"bgr8", 3, -1},
                                                           {"8UC3", 3, -1},
                                                           {"rgba8", 4, cv::COLOR_RGBA2BGR},
                                                           {"bgra8", 4, cv::COLOR_BGRA2BGR},
                                                           {"mono8", 1, -1},
                                                           {"8UC1", 1, -1}}};

[[noreturn]] void fail(const std::string& sentence) { throw BagDamage("sources.image_unreadable", sentence); }

std::string sizeText(std::uint32_t width_px, std::uint32_t height_px) {
  return std::to_string(width_px) + "x" + std::to_string(height_px);
}

void requireSize(std::uint32_t width_px, std::uint32_t height_px) {
  if (width_px > 0 && height_px > 0 && width_px <= core::kLargestImage_px && height_px <= core::kLargestImage_px)
    return;
  fail("claims an image of " + sizeText(width_px, height_px) + " pixels");
}

/// The rows of an image as they lie in the message.
cv::Mat rowsOf(const Image& image, int type) {
  requireSize(image.width_px, image.height_px);
  const std::uint64_t row_bytes = std::uint64_t{image.width_px} * static_cast<std::uint64_t>(CV_ELEM_SIZE(type));
  const std::uint64_t needed = std::uint64_t{image.step_bytes} * (image.height_px - 1) + row_bytes;
  if (image.step_bytes < row_bytes || needed > image.data.size) {
    fail("says " + sizeText(image.width_px, image.height_px) + " pixels of " + image.encoding + " in rows of " +
         std::to_string(image.step_bytes) + " bytes, which " + std::to_string(image.data.size) +
         " bytes of data do not hold");
  }
  return {static_cast<int>(image.height_px), static_cast<int>(image.width_px), type,
          const_cast<std::uint8_t*>(image.data.data), image.step_bytes};
}

/// With the byte order of this computer (little-endian), and data of its own.
cv::Mat inOwnByteOrder(const cv::Mat& rows, bool isBigEndian) {
  cv::Mat image = rows.clone();
  if (!isBigEndian) return image;
  const std::size_t size = image.elemSize1();
  auto* bytes = image.ptr<std::uint8_t>();
  for (std::size_t at = 0; at < image.total() * size; at += size) std::reverse(bytes + at, bytes + at + size);
  return image;
}

DepthImage fromMetres(const cv::Mat& depth_m) {
  DepthImage depth;
  depth.unit_m = kStepOfMetres_m;
  depth.isOfMetres = true;
  depth.units.create(depth_m.size(), CV_16UC1);
  const double most = std::numeric_limits<std::uint16_t>::max();
  for (int row = 0; row < depth_m.rows; ++row) {
    const auto* from = depth_m.ptr<float>(row);
    auto* to = depth.units.ptr<std::uint16_t>(row);
    for (int column = 0; column < depth_m.cols; ++column) {
      const double units = std::round(static_cast<double>(from[column]) / kStepOfMetres_m);
      const bool isMeasured = std::isfinite(units) && units > 0.0;
      const bool isTooFar = isMeasured && units > most;
      to[column] = isMeasured && !isTooFar ? static_cast<std::uint16_t>(units) : std::uint16_t{0};
      depth.tooFar += isTooFar ? 1 : 0;
    }
  }
  return depth;
}

/// Before anything is unpacked.
void requireDecodableSize(ByteView file) {
  const core::ImageHeader header = core::imageHeader(file.data, file.size);
  if (header.kind == core::ImageHeader::Kind::Jpeg && header.width_px == 0) fail("is a JPEG without a frame");
  if (header.kind != core::ImageHeader::Kind::Png && header.kind != core::ImageHeader::Kind::Jpeg) {
    fail("is a compressed image that is neither JPEG nor PNG");
  }
  requireSize(header.width_px, header.height_px);
}

cv::Mat unpack(ByteView file, int flags) {
  requireDecodableSize(file);
  cv::Mat image;
  try {
    const cv::Mat raw(1, static_cast<int>(file.size), CV_8UC1, const_cast<std::uint8_t*>(file.data));
    image = cv::imdecode(raw, flags | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception&) {
    image.release();
  }
  if (image.empty()) fail("is a compressed image that cannot be decoded");
  return image;
}

cv::Mat unpackDepth(ByteView file) {
  cv::Mat depth = unpack(file, cv::IMREAD_UNCHANGED);
  if (depth.type() != CV_16UC1) {
    fail(
        "is a compressed image of 8 bits or several channels, in which the metres are lost; record the topic of the "
        "depth image itself, or its compressedDepth");
  }
  return depth;
}

}  // namespace

bool isColorEncoding(const std::string& encoding) {
  return std::any_of(kColorEncodings.begin(), kColorEncodings.end(),
                     [&](const ColorEncoding& known) { return encoding == known.name; });
}

bool isDepthEncoding(const std::string& encoding) {
  return encoding == "16UC1" || encoding == "mono16" || encoding == "32FC1";
}

bool isCompressedDepth(const std::string& format) { return format.find("compressedDepth") != std::string::npos; }

cv::Mat decodeColor(const Image& image) {
  const auto* known = std::find_if(kColorEncodings.begin(), kColorEncodings.end(),
                                   [&](const ColorEncoding& candidate) { return image.encoding == candidate.name; });
  if (known == kColorEncodings.end()) {
    fail("has the encoding '" + image.encoding +
         "', which is no colour image that is read (rgb8, bgr8, rgba8, bgra8, mono8); convert it with image_proc");
  }
  const cv::Mat rows = rowsOf(image, CV_MAKETYPE(CV_8U, known->channels));
  if (known->toBgr < 0) return rows.clone();
  cv::Mat bgr;
  cv::cvtColor(rows, bgr, known->toBgr);
  return bgr;
}

cv::Mat decodeColor(const CompressedImage& image) {
  if (isCompressedDepth(image.format)) fail("is a depth image (" + image.format + "), not one of colours");
  return unpack(image.data, cv::IMREAD_COLOR);
}

DepthImage decodeDepth(const Image& image) {
  if (image.encoding == "32FC1") return fromMetres(inOwnByteOrder(rowsOf(image, CV_32FC1), image.isBigEndian));
  if (!isDepthEncoding(image.encoding)) {
    fail("has the encoding '" + image.encoding + "', which is no depth image that is read (16UC1, mono16, 32FC1)");
  }
  return {inOwnByteOrder(rowsOf(image, CV_16UC1), image.isBigEndian), kMillimetre_m, false, 0};
}

DepthImage decodeDepth(const CompressedImage& image) {
  if (!isCompressedDepth(image.format)) return {unpackDepth(image.data), kMillimetre_m, false, 0};
  ByteCursor cursor(image.data, "a compressedDepth image");
  const ByteView header = cursor.take(kDepthHeader_bytes);
  const ByteView packed = cursor.take(cursor.left());
  const bool isRvl = image.format.find("rvl") != std::string::npos;
  const cv::Mat units = isRvl ? decodeRvl(packed) : unpackDepth(packed);
  if (image.format.find("32FC1") == std::string::npos) return {units, kMillimetre_m, false, 0};
  float a = 0.0F;
  float b = 0.0F;
  std::memcpy(&a, header.data + 4, sizeof a);  // behind the number of the format
  std::memcpy(&b, header.data + 8, sizeof b);
  return fromMetres(depthOfInverse(units, a, b));
}

}  // namespace wardslam::bags
