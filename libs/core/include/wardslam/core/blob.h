#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <type_traits>
#include <vector>

/// Blobs, as in the map file: one byte for what it is, one for the version of its layout, then a zstd frame with
/// checksum. Numbers inside are little-endian.
namespace wardslam::core {

using Bytes = std::vector<std::uint8_t>;

enum class BlobKind : std::uint8_t {
  Features = 'F',
  CloudTile = 'C',
  FloorCells = 'G',
  FreeFan = 'S',
  TileMemory = 'M',
  DepthView = 'D',
  Observation = 'O',
  MergeWork = 'W'
};

/// A blob is not what it should be; says how, not where.
class BlobError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class ByteWriter {
 public:
  /// What there will be at most, where that is known: spares moving it about.
  void reserve(std::size_t size) { bytes_.reserve(size); }
  template <class T>
  void put(const T& value) {
    static_assert(std::is_arithmetic_v<T>);
    putBytes(&value, sizeof(T));
  }
  void putBytes(const void* bytes, std::size_t size);

  [[nodiscard]] const Bytes& bytes() const { return bytes_; }

 private:
  Bytes bytes_;
};

/// Never reads beyond the end: throws BlobError instead.
class ByteReader {
 public:
  explicit ByteReader(const Bytes& bytes) : bytes_(bytes) {}

  template <class T>
  [[nodiscard]] T get() {
    static_assert(std::is_arithmetic_v<T>);
    T value{};
    getBytes(&value, sizeof(T));
    return value;
  }
  void getBytes(void* to, std::size_t size);

  /// Reads a count of records and makes sure that exactly so many, of this size, follow.
  [[nodiscard]] std::size_t getCount(std::size_t recordSize);

  /// Reads a count of records that take at least so many bytes each, and makes sure that they can follow.
  [[nodiscard]] std::size_t getCountOfAtLeast(std::size_t smallestRecord);

  [[nodiscard]] std::size_t left() const { return bytes_.size() - position_; }

 private:
  const Bytes& bytes_;
  std::size_t position_ = 0;
};

/// `level`: zstd's, 1 is quickest.
[[nodiscard]] Bytes pack(BlobKind kind, std::uint8_t version, const Bytes& content, int level = 3);

/// Of the layout; 0 where it is no blob.
[[nodiscard]] std::uint8_t versionOf(const Bytes& blob);

/// The content. Throws BlobError when the blob is of another kind or version, or damaged.
[[nodiscard]] Bytes unpack(BlobKind kind, std::uint8_t version, const Bytes& blob);

}  // namespace wardslam::core
