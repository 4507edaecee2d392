#include "mcap_bag.h"

#include <algorithm>

namespace wardslam::bags {
namespace {

// Kinds of records ("opcodes").
constexpr std::uint8_t kFooter = 0x02;
constexpr std::uint8_t kSchema = 0x03;
constexpr std::uint8_t kChannel = 0x04;
constexpr std::uint8_t kMessage = 0x05;
constexpr std::uint8_t kChunk = 0x06;
constexpr std::uint8_t kMessageIndex = 0x07;

constexpr std::uint64_t kRecordHead_bytes = 9;  // kind, length
constexpr std::uint64_t kMessageHead_bytes = 22;
constexpr std::uint64_t kLongestChunkHead_bytes = 64;

Wire wireOf(const std::string& encoding) {
  if (encoding == "cdr") return Wire::Cdr;
  return encoding == "ros1" ? Wire::Ros1 : Wire::Unknown;
}

}  // namespace

McapBag::McapBag(const std::filesystem::path& path) : ChunkedBag(path) {
  scan(kMagic_bytes);
  addFromIndices();
  sortByTime();
}

void McapBag::scan(std::uint64_t offset) {
  while (offset < file_.size() && !isComplete_) {
    try {
      const Record record = recordHeadAt(offset);
      scanRecord(offset, record);
      offset = record.content_offset + record.content_bytes;
    } catch (const BagDamage& damage) {
      note("sources.bag_truncated", "is cut off or damaged at byte " + std::to_string(offset) + " (" + damage.what() +
                                        "); what stands before is read");
      return;
    }
  }
  if (!isComplete_) {
    note("sources.bag_truncated",
         "was not closed by its recorder, so its end may be missing; what is complete is read");
  }
}

void McapBag::scanRecord(std::uint64_t offset, const Record& record) {
  const auto content = [&] { return file_.read(record.content_offset, record.content_bytes); };
  switch (record.kind) {
    case kFooter:
      isComplete_ = true;
      break;
    case kSchema:
      addSchema(content());
      break;
    case kChannel:
      addChannel(content());
      break;
    case kMessage: {
      const auto head_bytes = std::min(record.content_bytes, kMessageHead_bytes);
      addMessage(file_.read(record.content_offset, head_bytes), {kNoChunk, offset});
      break;
    }
    case kChunk:
      addChunk(record);
      break;
    case kMessageIndex:
      addIndex(content());
      break;
    default:
      break;  // what sums up, attachments, and what later versions add
  }
}

McapBag::Record McapBag::recordHeadAt(std::uint64_t offset) {
  const Bytes raw = file_.read(offset, kRecordHead_bytes);
  ByteCursor cursor(raw, "");
  Record record;
  record.kind = cursor.number<std::uint8_t>();
  record.content_bytes = cursor.number<std::uint64_t>();
  record.content_offset = offset + kRecordHead_bytes;
  if (!file_.has(record.content_offset, record.content_bytes)) {
    throw BagDamage("sources.bag_truncated",
                    "the record there should have " + std::to_string(record.content_bytes) + " bytes");
  }
  return record;
}

void McapBag::addChunk(const Record& record) {
  const Bytes head = file_.read(record.content_offset, std::min(record.content_bytes, kLongestChunkHead_bytes));
  ByteCursor cursor(head, "the head of a chunk");
  cursor.take(2 * sizeof(std::uint64_t));  // first and last time
  Chunk chunk;
  chunk.size_bytes = cursor.number<std::uint64_t>();
  chunk.crc = cursor.number<std::uint32_t>();
  chunk.coding = cursor.text();
  chunk.packed_bytes = cursor.number<std::uint64_t>();
  chunk.offset = record.content_offset + cursor.position();
  if (chunk.packed_bytes > record.content_bytes - cursor.position()) {
    throw BagDamage("sources.bag_damaged", "a chunk claims more bytes than its record has");
  }
  chunks_.push_back(std::move(chunk));
  indices_.emplace_back();
}

void McapBag::addIndex(ByteView content) {
  if (chunks_.empty()) throw BagDamage("sources.bag_damaged", "there is an index before any chunk");
  ByteCursor cursor(content, "the index behind a chunk");
  const auto channel = cursor.number<std::uint16_t>();
  ByteCursor records(cursor.counted(), "the index behind a chunk");
  while (records.left() > 0) {
    const auto logged_ns = records.number<std::uint64_t>();
    indices_.back().push_back({channel, logged_ns, records.number<std::uint64_t>()});
  }
}

void McapBag::addSchema(ByteView content) {
  ByteCursor cursor(content, "a schema");
  const auto id = cursor.number<std::uint16_t>();
  schemas_[id] = cursor.text();
}

void McapBag::addChannel(ByteView content) {
  ByteCursor cursor(content, "a channel");
  const auto id = cursor.number<std::uint16_t>();
  const auto schema = cursor.number<std::uint16_t>();
  const std::string name = cursor.text();
  const std::string encoding = cursor.text();
  const auto type = schemas_.find(schema);
  topicOf_.try_emplace(id, topic(name, type == schemas_.end() ? "" : type->second, wireOf(encoding)));
}

void McapBag::addMessage(ByteView content, Place place) {
  ByteCursor cursor(content, "a message");
  const auto known = topicOf_.find(cursor.number<std::uint16_t>());
  if (known == topicOf_.end()) throw BagDamage("sources.bag_damaged", "a message is of no topic");
  cursor.take(sizeof(std::uint32_t));  // its number
  add(known->second, cursor.number<std::uint64_t>(), place);
}

/// Chunks that have no index, or one of channels that are told nowhere else, are unpacked and looked through; so is the
/// last one of a file that was cut off, whose index may be.
void McapBag::addFromIndices() {
  for (std::uint32_t chunk = 0; chunk < chunks_.size(); ++chunk) {
    const auto& index = indices_[chunk];
    const bool isKnown = std::all_of(index.begin(), index.end(),
                                     [this](const Indexed& message) { return topicOf_.count(message.channel) > 0; });
    if (index.empty() || !isKnown || !isComplete_) {
      try {
        addFromContent(chunk);
      } catch (const BagDamage& damage) {
        note(damage.event(), std::string(damage.what()) + "; what follows there is left out");
      }
      continue;
    }
    for (const Indexed& message : index) add(topicOf_.at(message.channel), message.logged_ns, {chunk, message.offset});
  }
  indices_.clear();
}

void McapBag::addFromContent(std::uint32_t chunk) {
  const auto content = unpack(chunk);
  ByteCursor cursor(*content, "a record of the chunk at byte " + std::to_string(chunks_[chunk].offset));
  while (cursor.left() > 0) {
    const std::size_t offset = cursor.position();
    const auto kind = cursor.number<std::uint8_t>();
    const ByteView record = cursor.take(cursor.number<std::uint64_t>());
    if (kind == kSchema) addSchema(record);
    if (kind == kChannel) addChannel(record);
    if (kind == kMessage) addMessage(record, {chunk, offset});
  }
}

ByteView McapBag::messageIn(ByteView record) const {
  ByteCursor cursor(record, "the record of a message");
  if (cursor.number<std::uint8_t>() != kMessage) {
    throw BagDamage("sources.bag_damaged", "the index points to something that is no message");
  }
  ByteCursor content(cursor.take(cursor.number<std::uint64_t>()), "the record of a message");
  content.take(kMessageHead_bytes);
  return content.take(content.left());
}

Bytes McapBag::recordAt(std::uint64_t offset) {
  const Record record = recordHeadAt(offset);
  return file_.read(offset, kRecordHead_bytes + record.content_bytes);
}

}  // namespace wardslam::bags
