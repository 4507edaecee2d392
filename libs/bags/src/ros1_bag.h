#pragma once

#include <map>
#include <set>

#include "chunked_bag.h"

namespace wardslam::bags {

/// A bag of ROS 1, version 2.0 (http://wiki.ros.org/Bags/Format/2.0). It need not have an index at its end, nor be
/// complete: records are read from the beginning on, as far as they go.
class Ros1Bag : public ChunkedBag {
 public:
  /// Throws core::InputError for another version.
  explicit Ros1Bag(const std::filesystem::path& path);

  static constexpr const char* kMagic = "#ROSBAG V";

 protected:
  [[nodiscard]] ByteView messageIn(ByteView record) const override;
  [[nodiscard]] Bytes recordAt(std::uint64_t offset) override;

 private:
  using Fields = std::map<std::string, ByteView>;

  /// Where the header and the data of a record lie.
  struct Record {
    Bytes header;
    std::uint64_t data_offset = 0;
    std::uint64_t data_bytes = 0;
  };

  void scan(std::uint64_t offset);
  [[nodiscard]] bool scanRecord(const Record& record);
  [[nodiscard]] Record recordHeadAt(std::uint64_t offset);
  [[nodiscard]] bool addChunk(const Fields& fields, const Record& record);
  void addIndex(const Fields& fields, ByteView data);
  void addConnection(const Fields& fields, ByteView data);
  void addFromIndices();
  void addFromContent(std::uint32_t chunk);

  /// What the index behind a chunk says: the messages of one connection.
  struct Index {
    std::uint32_t connection = 0;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> messages;  ///< Time (ns), offset in the chunk.
  };

  std::map<std::uint32_t, std::size_t> topicOf_;  ///< By connection.
  std::vector<std::vector<Index>> indices_;       ///< By chunk.
  bool hasTrailer_ = false;                       ///< Chunks are summed up at the end of the file: it is complete.
};

}  // namespace wardslam::bags
