#pragma once

#include <map>

#include "chunked_bag.h"

namespace wardslam::bags {

/// An MCAP file (https://mcap.dev/spec) with messages as ROS 1 or ROS 2 serialises them. It need not have an index, nor
/// be complete: records are read from the beginning on, as far as they go. Check sums of chunks are checked.
class McapBag : public ChunkedBag {
 public:
  explicit McapBag(const std::filesystem::path& path);

  static constexpr char kMagic[] = "\x89MCAP0\r\n";
  static constexpr std::size_t kMagic_bytes = 8;

 protected:
  [[nodiscard]] ByteView messageIn(ByteView record) const override;
  [[nodiscard]] Bytes recordAt(std::uint64_t offset) override;

 private:
  struct Record {
    std::uint8_t kind = 0;
    std::uint64_t content_offset = 0;
    std::uint64_t content_bytes = 0;
  };

  /// A message as an index has it.
  struct Indexed {
    std::uint16_t channel = 0;
    std::uint64_t logged_ns = 0;
    std::uint64_t offset = 0;
  };

  void scan(std::uint64_t offset);
  void scanRecord(std::uint64_t offset, const Record& record);
  [[nodiscard]] Record recordHeadAt(std::uint64_t offset);
  void addChunk(const Record& record);
  void addIndex(ByteView content);
  void addSchema(ByteView content);
  void addChannel(ByteView content);
  void addMessage(ByteView content, Place place);
  void addFromIndices();
  void addFromContent(std::uint32_t chunk);

  std::map<std::uint16_t, std::string> schemas_;  ///< Names of types.
  std::map<std::uint16_t, std::size_t> topicOf_;  ///< By channel.
  std::vector<std::vector<Indexed>> indices_;     ///< By chunk.
  bool isComplete_ = false;
};

}  // namespace wardslam::bags
