#pragma once

#include <string>

#include "byte_cursor.h"

namespace wardslam::bags {

/// No chunk may have more bytes once it is unpacked; recorders make them of 1 to 16 MiB.
inline constexpr std::uint64_t kLargestChunk_bytes = std::uint64_t{1} << 30U;

/// Unpacks what was packed as `coding`: "" or "none", "bz2", "lz4" (a frame), "zstd". Memory grows with what comes out,
/// not with what `size` claims. Throws BagDamage where that is not `size` bytes, or the coding is another.
[[nodiscard]] Bytes decompress(const std::string& coding, ByteView packed, std::uint64_t size);

/// A frame of Zstandard that may not tell its size beforehand.
[[nodiscard]] Bytes decompressZstd(ByteView packed);

}  // namespace wardslam::bags
