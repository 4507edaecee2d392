#pragma once

#include <cstddef>
#include <cstdint>

namespace wardslam::core {

/// Wider or higher is no camera's image, and what a damaged or malicious file says of itself must not make us allocate.
inline constexpr std::uint32_t kLargestImage_px = 16384;

/// What an encoded image says of its size before anything is unpacked.
struct ImageHeader {
  enum class Kind : std::uint8_t { Png, Jpeg, Bmp, Netpbm, Other };

  Kind kind = Kind::Other;
  std::uint32_t width_px = 0;  ///< 0: not told where it is looked for.
  std::uint32_t height_px = 0;

  /// True, too, where the size is not known.
  [[nodiscard]] bool isTooLarge() const { return width_px > kLargestImage_px || height_px > kLargestImage_px; }
};

/// Told by the first bytes: PNG; JPEG (its first frame); BMP; PBM, PGM, PPM and PFM. Never reads beyond the end.
[[nodiscard]] ImageHeader imageHeader(const std::uint8_t* data, std::size_t size);

}  // namespace wardslam::core
