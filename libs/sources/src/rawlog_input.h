#pragma once

#include <mrpt/io/CStream.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "byte_source.h"

namespace wardslam::sources {

/// A file, compressed or not, for MRPT's archives. Unlike mrpt::io::CFileGZInputStream it remembers what it read, tells
/// how far in the compressed file it is, and reads what newer versions of MRPT compress.
class RawlogInput : public mrpt::io::CStream {
 public:
  /// Throws core::InputError where there is no such file.
  explicit RawlogInput(const std::filesystem::path& file);

  /// Content bytes read since the last forget().
  [[nodiscard]] const std::vector<std::uint8_t>& remembered() const { return remembered_; }
  void forget() { remembered_.clear(); }

  /// Share of the file that is read, 0..1.
  [[nodiscard]] double fraction() const;

  std::size_t Read(void* to, std::size_t size) override;
  std::size_t Write(const void* from, std::size_t size) override;                         // not for this
  std::uint64_t Seek(std::int64_t offset, TSeekOrigin origin = sFromBeginning) override;  // nor this
  [[nodiscard]] std::uint64_t getTotalBytesCount() const override;                        // nor this
  [[nodiscard]] std::uint64_t getPosition() const override { return position_bytes_; }    // in the content

 private:
  std::unique_ptr<ByteSource> in_;
  std::uintmax_t size_bytes_ = 0;
  std::uint64_t position_bytes_ = 0;
  std::vector<std::uint8_t> remembered_;
};

}  // namespace wardslam::sources
