#include "byte_source.h"

#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <climits>
#include <fstream>
#include <string_view>
#include <vector>

#include "wardslam/core/errors.h"
#include "wardslam/core/first_bytes.h"

namespace wardslam::sources {
namespace {

namespace fs = std::filesystem;

/// zlib reads what is not compressed as it is.
class GzipBytes : public ByteSource {
 public:
  explicit GzipBytes(gzFile file) : in_(file, gzclose_r) {
    constexpr unsigned kBuffer_bytes = 1U << 17U;
    gzbuffer(file, kBuffer_bytes);
  }

  [[nodiscard]] std::size_t read(std::uint8_t* to, std::size_t size) override {
    std::size_t done = 0;
    while (done < size) {
      const auto step = static_cast<unsigned>(std::min<std::size_t>(size - done, INT_MAX));
      const int count = gzread(in_.get(), to + done, step);
      if (count <= 0) break;
      done += static_cast<std::size_t>(count);
    }
    return done;
  }
  [[nodiscard]] std::uint64_t consumed_bytes() const override {
    return static_cast<std::uint64_t>(std::max<z_off_t>(0, gzoffset(in_.get())));
  }

 private:
  std::unique_ptr<gzFile_s, int (*)(gzFile)> in_;
};

class ZstdBytes : public ByteSource {
 public:
  explicit ZstdBytes(const fs::path& file)
      : in_(file, std::ios::binary), stream_(ZSTD_createDStream(), ZSTD_freeDStream), buffer_(ZSTD_DStreamInSize()) {}

  [[nodiscard]] std::size_t read(std::uint8_t* to, std::size_t size) override {
    ZSTD_outBuffer out{to, size, 0};
    while (out.pos < out.size) {
      const std::size_t before = out.pos;
      if (input_.pos == input_.size && !refill() && !hasMore_) break;
      const std::size_t status = ZSTD_decompressStream(stream_.get(), &out, &input_);
      if (ZSTD_isError(status) != 0) break;
      hasMore_ = out.pos == out.size;  // what is kept back comes without further input
      if (out.pos == before && input_.size == 0) break;
    }
    return out.pos;
  }
  [[nodiscard]] std::uint64_t consumed_bytes() const override { return consumed_bytes_ - (input_.size - input_.pos); }

 private:
  bool refill() {
    in_.read(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    input_ = {buffer_.data(), static_cast<std::size_t>(in_.gcount()), 0};
    consumed_bytes_ += input_.size;
    return input_.size > 0;
  }

  std::ifstream in_;
  std::unique_ptr<ZSTD_DStream, std::size_t (*)(ZSTD_DStream*)> stream_;
  std::vector<char> buffer_;
  ZSTD_inBuffer input_{nullptr, 0, 0};
  std::uint64_t consumed_bytes_ = 0;
  bool hasMore_ = false;
};

bool isZstd(const fs::path& file) {
  constexpr std::string_view kMagic = "\x28\xB5\x2F\xFD";
  return core::firstBytes(file, kMagic.size()) == kMagic;
}

}  // namespace

std::unique_ptr<ByteSource> openBytes(const fs::path& file) {
  if (fs::is_regular_file(file)) {
    if (isZstd(file)) return std::make_unique<ZstdBytes>(file);
    if (gzFile gz = gzopen(file.c_str(), "rb")) return std::make_unique<GzipBytes>(gz);
  }
  throw core::InputError(file.string() + ": cannot be opened as a rawlog file");
}

}  // namespace wardslam::sources
