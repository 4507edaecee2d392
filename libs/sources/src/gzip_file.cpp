#include "wardslam/sources/gzip_file.h"

#include <array>
#include <fstream>

namespace wardslam::sources {

std::optional<std::uint32_t> gzipContentSize(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (in.get() != 0x1F || in.get() != 0x8B) return std::nullopt;
  std::array<char, 4> bytes{};
  in.seekg(-static_cast<std::streamoff>(bytes.size()), std::ios::end);
  if (!in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) return std::nullopt;

  std::uint32_t size = 0;  // little endian
  for (std::size_t i = 0; i < bytes.size(); ++i) size |= std::uint32_t{static_cast<std::uint8_t>(bytes[i])} << 8 * i;
  return size;
}

}  // namespace wardslam::sources
