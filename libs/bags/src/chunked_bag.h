#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "byte_cursor.h"
#include "input_file.h"
#include "wardslam/bags/bag_reader.h"

namespace wardslam::bags {

/// A run of messages that were packed together.
struct Chunk {
  std::uint64_t offset = 0;  ///< Of its data, in the file.
  std::uint64_t packed_bytes = 0;
  std::uint64_t size_bytes = 0;
  std::string coding;
  std::uint32_t crc = 0;  ///< CRC-32 of what comes out; 0: not told.
};

/// What ROS 1 bags and MCAP files have in common: messages in chunks, and chunks in a file. How records look is up to
/// the classes derived from it, which list chunks, topics and messages when they are made.
class ChunkedBag : public BagReader {
 public:
  [[nodiscard]] Bytes read(std::size_t entry) override;

 protected:
  static constexpr std::uint32_t kNoChunk = UINT32_MAX;

  /// Where a message stands: in a chunk that is unpacked, or in the file itself.
  struct Place {
    std::uint32_t chunk = kNoChunk;
    std::uint64_t offset = 0;
  };

  explicit ChunkedBag(const std::filesystem::path& path) : file_(path) {}

  /// The serialised message in the record that begins the bytes.
  [[nodiscard]] virtual ByteView messageIn(ByteView record) const = 0;

  /// The record of a message at this place of the file, which stands in no chunk.
  [[nodiscard]] virtual Bytes recordAt(std::uint64_t offset) = 0;

  /// The content of a chunk; the last few stay unpacked. Throws BagDamage.
  [[nodiscard]] std::shared_ptr<const Bytes> unpack(std::uint32_t chunk);

  /// The topic of this name and type, added where it is new. Type and wire may be those of any version of ROS.
  std::size_t topic(const std::string& name, const std::string& type, Wire wire);

  void add(std::size_t topic, std::uint64_t logged_ns, Place place);
  void sortByTime();
  void note(const std::string& event, const std::string& sentence) { damage_.emplace_back(event, sentence); }

  InputFile file_;
  std::vector<Chunk> chunks_;

 private:
  std::vector<Place> places_;  ///< Of entries_.
  std::map<std::pair<std::string, std::string>, std::size_t> topicAt_;
  std::deque<std::pair<std::uint32_t, std::shared_ptr<const Bytes>>> unpacked_;  ///< The one used last is in front.
};

/// "sensor_msgs/msg/Image" or "sensor_msgs::msg::dds_::Image_" as "sensor_msgs/Image".
[[nodiscard]] std::string plainTypeName(const std::string& type);

}  // namespace wardslam::bags
