#include "ros1_bag.h"

#include <algorithm>

#include "wardslam/core/errors.h"

namespace wardslam::bags {
namespace {

// Values of the field `op`.
constexpr std::uint8_t kMessage = 0x02;
constexpr std::uint8_t kIndex = 0x04;
constexpr std::uint8_t kChunk = 0x05;
constexpr std::uint8_t kChunkInfo = 0x06;
constexpr std::uint8_t kConnection = 0x07;

constexpr std::uint32_t kLongestHeader_bytes = 1U << 20U;

std::map<std::string, ByteView> fieldsOf(ByteView header) {
  std::map<std::string, ByteView> fields;
  ByteCursor cursor(header, "the header of a record");
  while (cursor.left() > 0) {
    const ByteView field = cursor.counted();
    const auto* end = field.data + field.size;
    const auto* equals = std::find(field.data, end, static_cast<std::uint8_t>('='));
    if (equals == end) throw BagDamage("sources.bag_damaged", "a field of a record has no '='");
    const std::string name(field.data, equals);
    fields[name] = {equals + 1, static_cast<std::size_t>(end - equals - 1)};
  }
  return fields;
}

template <class Number>
Number numberOf(const std::map<std::string, ByteView>& fields, const char* name) {
  const auto found = fields.find(name);
  if (found == fields.end()) throw BagDamage("sources.bag_damaged", std::string("a record has no field ") + name);
  return ByteCursor(found->second, std::string("the field ") + name).number<Number>();
}

std::string textOf(const std::map<std::string, ByteView>& fields, const char* name) {
  const auto found = fields.find(name);
  if (found == fields.end()) return {};
  return {reinterpret_cast<const char*>(found->second.data), found->second.size};
}

/// Seconds and nanoseconds, as they stand side by side, in nanoseconds.
std::uint64_t nanoseconds(std::uint64_t time) { return (time & 0xFFFFFFFFU) * 1'000'000'000U + (time >> 32U); }

}  // namespace

Ros1Bag::Ros1Bag(const std::filesystem::path& path) : ChunkedBag(path) {
  const std::string expected = std::string(kMagic) + "2.0\n";
  const Bytes head = file_.read(0, std::min<std::uint64_t>(expected.size(), file_.size()));
  if (std::string(head.begin(), head.end()) != expected) {
    throw core::InputError(path.string() +
                           ": is a ROS 1 bag of another version than 2.0; rewrite it with 'rosbag fix'");
  }
  scan(expected.size());
  addFromIndices();
  sortByTime();
}

void Ros1Bag::scan(std::uint64_t offset) {
  while (offset < file_.size()) {
    try {
      const Record record = recordHeadAt(offset);
      if (!scanRecord(record))
        throw BagDamage("sources.bag_truncated", "its recorder was ended in the middle of a chunk");
      offset = record.data_offset + record.data_bytes;
    } catch (const BagDamage& damage) {
      note("sources.bag_truncated", "is cut off or damaged at byte " + std::to_string(offset) + " (" + damage.what() +
                                        "); what stands before is read");
      return;
    }
  }
  if (!hasTrailer_ && !chunks_.empty()) {
    note("sources.bag_truncated",
         "was not closed by its recorder, so its end may be missing; what is complete is read");
  }
}

/// False: a chunk that was begun only.
bool Ros1Bag::scanRecord(const Record& record) {
  const Fields fields = fieldsOf(record.header);
  switch (numberOf<std::uint8_t>(fields, "op")) {
    case kChunk:
      return addChunk(fields, record);
    case kIndex:
      addIndex(fields, file_.read(record.data_offset, record.data_bytes));
      break;
    case kConnection:
      addConnection(fields, file_.read(record.data_offset, record.data_bytes));
      break;
    case kChunkInfo:
      hasTrailer_ = true;
      break;
    default:
      break;  // the head of the file, and what later minor versions add
  }
  return true;
}

Ros1Bag::Record Ros1Bag::recordHeadAt(std::uint64_t offset) {
  const Bytes raw = file_.read(offset, sizeof(std::uint32_t));
  const auto header_bytes = ByteCursor(raw, "").number<std::uint32_t>();
  if (header_bytes > kLongestHeader_bytes) {
    throw BagDamage("sources.bag_damaged",
                    "a record's header of " + std::to_string(header_bytes) + " bytes cannot be right");
  }
  Record record;
  record.header = file_.read(offset + raw.size(), header_bytes);
  const std::uint64_t behind = offset + raw.size() + header_bytes;
  const Bytes rawSize = file_.read(behind, sizeof(std::uint32_t));
  record.data_bytes = ByteCursor(rawSize, "").number<std::uint32_t>();
  record.data_offset = behind + rawSize.size();
  if (!file_.has(record.data_offset, record.data_bytes)) {
    throw BagDamage("sources.bag_truncated",
                    "the record there should have " + std::to_string(record.data_bytes) + " bytes of data");
  }
  return record;
}

bool Ros1Bag::addChunk(const Fields& fields, const Record& record) {
  Chunk chunk{record.data_offset, record.data_bytes, numberOf<std::uint32_t>(fields, "size"),
              textOf(fields, "compression"), 0};
  if (chunk.size_bytes == 0 && chunk.packed_bytes == 0) return false;  // both are filled in when a chunk is complete
  chunks_.push_back(std::move(chunk));
  indices_.emplace_back();
  return true;
}

void Ros1Bag::addIndex(const Fields& fields, ByteView data) {
  if (chunks_.empty()) throw BagDamage("sources.bag_damaged", "there is an index before any chunk");
  const auto count = numberOf<std::uint32_t>(fields, "count");
  Index index;
  index.connection = numberOf<std::uint32_t>(fields, "conn");
  ByteCursor cursor(data, "the index behind a chunk");
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto time = cursor.number<std::uint64_t>();
    index.messages.emplace_back(nanoseconds(time), cursor.number<std::uint32_t>());
  }
  indices_.back().push_back(std::move(index));
}

void Ros1Bag::addConnection(const Fields& fields, ByteView data) {
  const Fields about = fieldsOf(data);
  const auto connection = numberOf<std::uint32_t>(fields, "conn");
  topicOf_.try_emplace(connection, topic(textOf(fields, "topic"), textOf(about, "type"), Wire::Ros1));
}

/// Chunks that have no index, or one of connections that are told nowhere else, are unpacked and looked through.
void Ros1Bag::addFromIndices() {
  for (std::uint32_t chunk = 0; chunk < chunks_.size(); ++chunk) {
    const auto& indices = indices_[chunk];
    const bool isKnown = std::all_of(indices.begin(), indices.end(),
                                     [this](const Index& index) { return topicOf_.count(index.connection) > 0; });
    if (indices.empty() || !isKnown || !hasTrailer_) {
      try {
        addFromContent(chunk);
      } catch (const BagDamage& damage) {
        note(damage.event(), std::string(damage.what()) + "; what follows there is left out");
      }
      continue;
    }
    for (const Index& index : indices) {
      for (const auto& [logged_ns, offset] : index.messages)
        add(topicOf_.at(index.connection), logged_ns, {chunk, offset});
    }
  }
  indices_.clear();
}

void Ros1Bag::addFromContent(std::uint32_t chunk) {
  const auto content = unpack(chunk);
  ByteCursor cursor(*content, "a record of the chunk at byte " + std::to_string(chunks_[chunk].offset));
  while (cursor.left() > 0) {
    const std::size_t offset = cursor.position();
    const Fields fields = fieldsOf(cursor.counted());
    const ByteView data = cursor.counted();
    const auto op = numberOf<std::uint8_t>(fields, "op");
    if (op == kConnection) addConnection(fields, data);
    if (op != kMessage) continue;
    const auto known = topicOf_.find(numberOf<std::uint32_t>(fields, "conn"));
    if (known == topicOf_.end()) throw BagDamage("sources.bag_damaged", "a message is of no topic");
    add(known->second, nanoseconds(numberOf<std::uint64_t>(fields, "time")), {chunk, offset});
  }
}

ByteView Ros1Bag::messageIn(ByteView record) const {
  ByteCursor cursor(record, "the record of a message");
  if (numberOf<std::uint8_t>(fieldsOf(cursor.counted()), "op") != kMessage) {
    throw BagDamage("sources.bag_damaged", "the index points to something that is no message");
  }
  return cursor.counted();
}

Bytes Ros1Bag::recordAt(std::uint64_t offset) {
  const Record record = recordHeadAt(offset);
  return file_.read(offset, record.data_offset + record.data_bytes - offset);
}

}  // namespace wardslam::bags
