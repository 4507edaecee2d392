#include "input_file.h"

#include "wardslam/core/errors.h"

namespace wardslam::bags {

InputFile::InputFile(const std::filesystem::path& path) : path_(path), in_(path, std::ios::binary) {
  std::error_code error;
  size_ = std::filesystem::file_size(path, error);
  if (!in_ || error) throw core::InputError(path.string() + ": cannot be opened; is it a file, and may you read it?");
}

Bytes InputFile::read(std::uint64_t offset, std::uint64_t count) {
  Bytes bytes;
  if (has(offset, count)) {
    bytes.resize(count);
    in_.clear();
    in_.seekg(static_cast<std::streamoff>(offset));
    in_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(count));
    if (in_) return bytes;
  }
  throw BagDamage("sources.bag_truncated",
                  "ends before the " + std::to_string(count) + " bytes that should stand at " + std::to_string(offset));
}

}  // namespace wardslam::bags
