#include "decompress.h"

#include <bzlib.h>
#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <memory>

namespace wardslam::bags {
namespace {

[[noreturn]] void failUnpacking(const std::string& coding, const std::string& why) {
  throw BagDamage("sources.bag_damaged", "cannot be unpacked (" + coding + "): " + why);
}

/// Grows as it is filled, up to a limit.
class Output {
 public:
  explicit Output(std::uint64_t limit) : limit_(limit) { bytes_.resize(std::min<std::uint64_t>(limit, kFirst_bytes)); }

  [[nodiscard]] std::uint8_t* place() { return bytes_.data() + filled_; }
  [[nodiscard]] std::size_t room() const { return bytes_.size() - filled_; }
  [[nodiscard]] std::size_t filled() const { return filled_; }
  void fill(std::size_t count) {
    filled_ += count;
    if (room() == 0) bytes_.resize(std::min<std::uint64_t>(limit_, 2 * bytes_.size()));
  }
  [[nodiscard]] Bytes finish() {
    bytes_.resize(filled_);
    return std::move(bytes_);
  }

 private:
  static constexpr std::uint64_t kFirst_bytes = 1U << 20U;
  std::uint64_t limit_;
  Bytes bytes_;
  std::size_t filled_ = 0;
};

void unpackBzip2(ByteView packed, Output& out) {
  bz_stream stream{};
  if (BZ2_bzDecompressInit(&stream, 0, 0) != BZ_OK) failUnpacking("bz2", "no memory");
  const std::unique_ptr<bz_stream, decltype(&BZ2_bzDecompressEnd)> ending(&stream, &BZ2_bzDecompressEnd);
  stream.next_in = const_cast<char*>(reinterpret_cast<const char*>(packed.data));
  stream.avail_in = static_cast<unsigned>(packed.size);
  for (int state = BZ_OK; state != BZ_STREAM_END;) {
    const std::size_t room = out.room();
    stream.next_out = reinterpret_cast<char*>(out.place());
    stream.avail_out = static_cast<unsigned>(room);
    state = BZ2_bzDecompress(&stream);
    if (state != BZ_OK && state != BZ_STREAM_END) failUnpacking("bz2", "error " + std::to_string(state));
    if (state == BZ_OK && stream.avail_out == room) failUnpacking("bz2", "its data end too early, or are too many");
    out.fill(room - stream.avail_out);
  }
}

void unpackLz4(ByteView packed, Output& out) {
  LZ4F_dctx* raw = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&raw, LZ4F_VERSION)) != 0) failUnpacking("lz4", "no memory");
  const std::unique_ptr<LZ4F_dctx, decltype(&LZ4F_freeDecompressionContext)> context(raw,
                                                                                     &LZ4F_freeDecompressionContext);
  std::size_t used = 0;
  for (std::size_t hint = 1; hint != 0;) {
    std::size_t produced = out.room();
    std::size_t consumed = packed.size - used;
    hint = LZ4F_decompress(context.get(), out.place(), &produced, packed.data + used, &consumed, nullptr);
    if (LZ4F_isError(hint) != 0) failUnpacking("lz4", LZ4F_getErrorName(hint));
    if (hint != 0 && produced == 0 && consumed == 0) failUnpacking("lz4", "its data end too early, or are too many");
    used += consumed;
    out.fill(produced);
  }
}

void unpackZstd(ByteView packed, Output& out) {
  const std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> context(ZSTD_createDCtx(), &ZSTD_freeDCtx);
  ZSTD_inBuffer input{packed.data, packed.size, 0};
  for (std::size_t hint = 1; hint != 0;) {
    ZSTD_outBuffer output{out.place(), out.room(), 0};
    const std::size_t before = input.pos;
    hint = ZSTD_decompressStream(context.get(), &output, &input);
    if (ZSTD_isError(hint) != 0) failUnpacking("zstd", ZSTD_getErrorName(hint));
    if (hint != 0 && output.pos == 0 && input.pos == before)
      failUnpacking("zstd", "its data end too early, or are too many");
    out.fill(output.pos);
  }
}

}  // namespace

Bytes decompress(const std::string& coding, ByteView packed, std::uint64_t size) {
  if (size > kLargestChunk_bytes) {
    throw BagDamage("sources.bag_damaged", "says that it has " + std::to_string(size) + " bytes once unpacked, where " +
                                               std::to_string(kLargestChunk_bytes) + " are the most that is read");
  }
  Output out(coding.empty() || coding == "none" ? 0 : size);
  if (coding.empty() || coding == "none") {
    if (packed.size != size) failUnpacking("none", "it has " + std::to_string(packed.size) + " bytes");
    return {packed.data, packed.data + packed.size};
  }
  if (coding == "bz2") {
    unpackBzip2(packed, out);
  } else if (coding == "lz4") {
    unpackLz4(packed, out);
  } else if (coding == "zstd") {
    unpackZstd(packed, out);
  } else {
    failUnpacking(coding, "a packing that is not known here; write the bag again with zstd, lz4 or none");
  }
  if (out.filled() != size) {
    failUnpacking(coding, std::to_string(out.filled()) + " bytes came out instead of " + std::to_string(size));
  }
  return out.finish();
}

Bytes decompressZstd(ByteView packed) {
  Output out(kLargestChunk_bytes);
  unpackZstd(packed, out);
  return out.finish();
}

}  // namespace wardslam::bags
