#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>

#include "wardslam/bags/bag_reader.h"

namespace wardslam::bags {

/// A file that is read from any place. Nothing is allocated for more bytes than it has.
class InputFile {
 public:
  /// Throws core::InputError where it cannot be opened.
  explicit InputFile(const std::filesystem::path& path);

  [[nodiscard]] std::uint64_t size() const { return size_; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] bool has(std::uint64_t offset, std::uint64_t count) const {
    return offset <= size_ && count <= size_ - offset;
  }

  /// Throws BagDamage where the file ends before.
  [[nodiscard]] Bytes read(std::uint64_t offset, std::uint64_t count);

 private:
  std::filesystem::path path_;
  std::ifstream in_;
  std::uint64_t size_ = 0;
};

}  // namespace wardslam::bags
