#include "wardslam/core/blob.h"

#include <zstd.h>

#include <cstring>
#include <memory>
#include <string>

namespace wardslam::core {
namespace {

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "blobs are little-endian; this machine needs byte swapping");

constexpr std::size_t kHeaderSize = 2;
/// What a damaged size can make us allocate. The largest floor plan (mapping::drawFloorPlan) has 4e8 cells.
constexpr unsigned long long kLargestContent = 512ULL << 20U;

[[noreturn]] void failDamaged() { throw BlobError("its content is damaged"); }

}  // namespace

void ByteWriter::putBytes(const void* bytes, std::size_t size) {
  const auto* const first = static_cast<const std::uint8_t*>(bytes);
  bytes_.insert(bytes_.end(), first, first + size);
}

void ByteReader::getBytes(void* to, std::size_t size) {
  if (size > bytes_.size() - position_) throw BlobError("its content ends early");
  if (size > 0) std::memcpy(to, bytes_.data() + position_, size);
  position_ += size;
}

std::size_t ByteReader::getCount(std::size_t recordSize) {
  const std::size_t count = get<std::uint32_t>();
  if ((bytes_.size() - position_) != count * recordSize) {
    throw BlobError("it should hold " + std::to_string(count) + " records, and its size says otherwise");
  }
  return count;
}

std::size_t ByteReader::getCountOfAtLeast(std::size_t smallestRecord) {
  const std::size_t count = get<std::uint32_t>();
  if (count > left() / smallestRecord)
    throw BlobError("it ends before the last of " + std::to_string(count) + " records");
  return count;
}

Bytes pack(BlobKind kind, std::uint8_t version, const Bytes& content, int level) {
  if (content.size() > kLargestContent) throw BlobError("it is too large: nobody could read it");
  const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(), ZSTD_freeCCtx);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, level);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
  Bytes blob(kHeaderSize + ZSTD_compressBound(content.size()));
  blob[0] = static_cast<std::uint8_t>(kind);
  blob[1] = version;
  const std::size_t size = ZSTD_compress2(context.get(), blob.data() + kHeaderSize, blob.size() - kHeaderSize,
                                          content.data(), content.size());
  if (ZSTD_isError(size) != 0) throw BlobError(std::string("it cannot be compressed: ") + ZSTD_getErrorName(size));
  blob.resize(kHeaderSize + size);
  return blob;
}

std::uint8_t versionOf(const Bytes& blob) { return blob.size() < kHeaderSize ? 0 : blob[1]; }

Bytes unpack(BlobKind kind, std::uint8_t version, const Bytes& blob) {
  if (blob.size() < kHeaderSize || blob[0] != static_cast<std::uint8_t>(kind)) failDamaged();
  if (blob[1] != version) {
    throw BlobError("its layout has version " + std::to_string(blob[1]) + ", known is " + std::to_string(version));
  }
  const std::uint8_t* const frame = blob.data() + kHeaderSize;
  const std::size_t frameSize = blob.size() - kHeaderSize;
  const unsigned long long size = ZSTD_getFrameContentSize(frame, frameSize);
  if (size > kLargestContent) failDamaged();  // the values for "unknown" and "error" are larger, too
  Bytes content(static_cast<std::size_t>(size));
  const std::size_t written = ZSTD_decompress(content.data(), content.size(), frame, frameSize);
  if (ZSTD_isError(written) != 0 || written != content.size()) failDamaged();
  return content;
}

}  // namespace wardslam::core
