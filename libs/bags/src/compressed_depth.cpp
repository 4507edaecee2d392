#include "compressed_depth.h"

#include <cmath>
#include <cstring>

#include "byte_cursor.h"

namespace wardslam::bags {
namespace {

/// Half bytes, eight in a word of 32 bits, the first in its highest bits; numbers of several have the lowest three bits
/// first, and bit 3 set where more follow.
class HalfBytes {
 public:
  explicit HalfBytes(ByteView words) : words_(words, "an image packed as RVL") {}

  std::uint32_t number() {
    std::uint32_t value = 0;
    for (unsigned shift = 0; shift < 32; shift += 3) {
      const std::uint32_t half = next();
      value |= (half & 7U) << shift;
      if ((half & 8U) == 0) return value;
    }
    throw BagDamage("sources.image_unreadable", "has a number without end in an image packed as RVL");
  }

 private:
  std::uint32_t next() {
    if (left_ == 0) {
      word_ = words_.number<std::uint32_t>();
      left_ = 8;
    }
    const std::uint32_t half = word_ >> 28U;
    word_ <<= 4U;
    --left_;
    return half;
  }

  ByteCursor words_;
  std::uint32_t word_ = 0;
  int left_ = 0;
};

}  // namespace

cv::Mat depthOfInverse(const cv::Mat& inverse, float a, float b) {
  cv::Mat depth_m(inverse.size(), CV_32FC1);
  depth_m.forEach<float>([&](float& out, const int* pixel) {
    const std::uint16_t value = inverse.at<std::uint16_t>(pixel);
    const float z_m = value == 0 ? 0.0F : a / (static_cast<float>(value) - b);
    out = std::isfinite(z_m) && z_m > 0.0F ? z_m : 0.0F;
  });
  return depth_m;
}

cv::Mat decodeRvl(ByteView packed) {
  ByteCursor head(packed, "an image packed as RVL");
  const auto width = head.number<std::uint32_t>();
  const auto height = head.number<std::uint32_t>();
  constexpr std::uint32_t kLargest_px = 16384;
  // Runs of nothing pack best: a few half bytes, whatever their length. So the size is bounded by itself.
  if (width == 0 || height == 0 || width > kLargest_px || height > kLargest_px) {
    throw BagDamage("sources.image_unreadable",
                    "claims an image of " + std::to_string(width) + "x" + std::to_string(height) + " pixels");
  }
  HalfBytes numbers(head.take(head.left()));
  cv::Mat image(static_cast<int>(height), static_cast<int>(width), CV_16UC1, cv::Scalar(0));
  auto* pixel = image.ptr<std::uint16_t>();
  auto* const end = pixel + image.total();
  std::uint32_t value = 0;
  while (pixel != end) {
    const std::uint32_t nothing = numbers.number();
    const std::uint32_t something = numbers.number();
    const auto room = static_cast<std::uint64_t>(end - pixel);
    if (std::uint64_t{nothing} + something > room || nothing + something == 0) {
      throw BagDamage("sources.image_unreadable", "has runs that do not fit into its image packed as RVL");
    }
    pixel += nothing;
    for (std::uint32_t i = 0; i < something; ++i) {
      const std::uint32_t zigzag = numbers.number();
      value += (zigzag >> 1U) ^ (~(zigzag & 1U) + 1U);
      *pixel++ = static_cast<std::uint16_t>(value);
    }
  }
  return image;
}

}  // namespace wardslam::bags
