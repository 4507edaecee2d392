#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>

namespace wardslam::sources {

/// The content of a file, decompressed as it is read.
class ByteSource {
 public:
  virtual ~ByteSource() = default;

  /// As many bytes as are wanted and there; fewer at the end, and where the file is damaged.
  [[nodiscard]] virtual std::size_t read(std::uint8_t* to, std::size_t size) = 0;
  [[nodiscard]] virtual std::uint64_t consumed_bytes() const = 0;  ///< Of the file, not of the content.
};

/// Chooses by the first bytes: Zstandard (MRPT from 2.15.7 on), gz, or as it is. Throws core::InputError where there is
/// no such file.
[[nodiscard]] std::unique_ptr<ByteSource> openBytes(const std::filesystem::path& file);

}  // namespace wardslam::sources
