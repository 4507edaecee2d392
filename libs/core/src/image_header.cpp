#include "wardslam/core/image_header.h"

#include <algorithm>
#include <cctype>
#include <limits>

namespace wardslam::core {
namespace {

class Head {
 public:
  Head(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::uint8_t at(std::size_t i) const { return i < size_ ? data_[i] : std::uint8_t{0}; }
  [[nodiscard]] std::uint32_t bigEndian(std::size_t at, int count) const {
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i) value = value << 8U | this->at(at++);
    return value;
  }
  [[nodiscard]] std::uint32_t littleEndian32(std::size_t at) const {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value << 8U | this->at(at + i);
    return value;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

ImageHeader ofPng(const Head& head) { return {ImageHeader::Kind::Png, head.bigEndian(16, 4), head.bigEndian(20, 4)}; }

ImageHeader ofJpeg(const Head& head) {
  ImageHeader header;
  header.kind = ImageHeader::Kind::Jpeg;
  for (std::size_t at = 2; at + 9 < head.size() && head.at(at) == 0xFF;) {
    const std::uint8_t marker = head.at(at + 1);
    const bool isFrame = marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
    if (isFrame) {
      header.width_px = head.bigEndian(at + 7, 2);
      header.height_px = head.bigEndian(at + 5, 2);
      break;
    }
    at += marker == 0xFF ? 1 : 2 + head.bigEndian(at + 2, 2);
  }
  return header;
}

/// Heights below 0 mean rows from the top.
std::uint32_t magnitude(std::uint32_t number) { return number > 0x7FFFFFFFU ? ~number + 1U : number; }

ImageHeader ofBmp(const Head& head) {
  constexpr std::uint32_t kOldHead_bytes = 12;  // of OS/2: numbers of 16 bits
  constexpr std::size_t kSizeEnds_bytes = 26;
  if (head.littleEndian32(14) == kOldHead_bytes) {
    return {ImageHeader::Kind::Bmp, head.littleEndian32(18) & 0xFFFFU, head.littleEndian32(18) >> 16U};
  }
  if (head.size() < kSizeEnds_bytes) return {ImageHeader::Kind::Bmp, 0, 0};
  return {ImageHeader::Kind::Bmp, magnitude(head.littleEndian32(18)), magnitude(head.littleEndian32(22))};
}

/// Words parted by blanks, and remarks from '#' to the end of the line.
ImageHeader ofNetpbm(const Head& head) {
  std::size_t at = 2;
  const auto number = [&] {
    while (at < head.size() && (std::isspace(head.at(at)) != 0 || head.at(at) == '#')) {
      const bool isRemark = head.at(at) == '#';
      while (isRemark && at < head.size() && head.at(at) != '\n') ++at;
      ++at;
    }
    constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();
    std::uint64_t value = 0;
    for (; std::isdigit(head.at(at)) != 0; ++at) value = std::min<std::uint64_t>(10 * value + head.at(at) - '0', kMost);
    return static_cast<std::uint32_t>(value);
  };
  ImageHeader header;
  header.kind = ImageHeader::Kind::Netpbm;
  header.width_px = number();
  header.height_px = number();
  return header;
}

}  // namespace

ImageHeader imageHeader(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kPngHead_bytes = 24;
  const Head head(data, size);
  if (size >= kPngHead_bytes && head.at(0) == 0x89 && head.at(1) == 'P') return ofPng(head);
  if (size >= 4 && head.at(0) == 0xFF && head.at(1) == 0xD8) return ofJpeg(head);
  if (size >= 4 && head.at(0) == 'B' && head.at(1) == 'M') return ofBmp(head);
  const bool isNetpbm = size >= 4 && head.at(0) == 'P' &&
                        ((head.at(1) >= '1' && head.at(1) <= '6') || head.at(1) == 'F' || head.at(1) == 'f');
  return isNetpbm ? ofNetpbm(head) : ImageHeader();
}

}  // namespace wardslam::core
