#pragma once

#include <mrpt/io/CStream.h>
#include <zlib.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace wardslam::sources {

/// A file, gz-compressed or not, for MRPT's archives. Unlike mrpt::io::CFileGZInputStream it remembers what it read,
/// and tells how far in the compressed file it is.
class GzipInput : public mrpt::io::CStream {
 public:
  /// Throws core::InputError where there is no such file.
  explicit GzipInput(const std::filesystem::path& file);

  /// Content bytes read since the last forget().
  [[nodiscard]] const std::vector<std::uint8_t>& remembered() const { return remembered_; }
  void forget() { remembered_.clear(); }

  /// Share of the file that is read, 0..1.
  [[nodiscard]] double fraction() const;

  std::size_t Read(void* to, std::size_t size) override;
  std::size_t Write(const void* from, std::size_t size) override;                         // not for this
  std::uint64_t Seek(std::int64_t offset, TSeekOrigin origin = sFromBeginning) override;  // nor this
  [[nodiscard]] std::uint64_t getTotalBytesCount() const override;                        // nor this
  [[nodiscard]] std::uint64_t getPosition() const override;                               // in the content

 private:
  std::unique_ptr<gzFile_s, int (*)(gzFile)> in_;
  std::uintmax_t size_bytes_ = 0;
  std::vector<std::uint8_t> remembered_;
};

}  // namespace wardslam::sources
