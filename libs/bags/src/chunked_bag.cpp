#include "chunked_bag.h"

#include <zlib.h>

#include <algorithm>
#include <numeric>

#include "decompress.h"

namespace wardslam::bags {
namespace {

constexpr std::size_t kMostUnpacked = 8;                              // recorders with several buffers interleave a few
constexpr std::size_t kMostUnpacked_bytes = std::size_t{256} << 20U;  // but one chunk is always kept

}  // namespace

Bytes ChunkedBag::read(std::size_t entry) {
  const Place place = places_.at(entry);
  if (place.chunk == kNoChunk) {
    const Bytes record = recordAt(place.offset);
    const ByteView message = messageIn(record);
    return {message.data, message.data + message.size};
  }
  const auto content = unpack(place.chunk);
  if (place.offset >= content->size()) {
    throw BagDamage("sources.bag_damaged", "the index points behind the end of its chunk");
  }
  const ByteView message = messageIn({content->data() + place.offset, content->size() - place.offset});
  return {message.data, message.data + message.size};
}

std::shared_ptr<const Bytes> ChunkedBag::unpack(std::uint32_t index) {
  const auto known = std::find_if(unpacked_.begin(), unpacked_.end(), [&](const auto& c) { return c.first == index; });
  if (known != unpacked_.end()) {
    std::rotate(unpacked_.begin(), known, known + 1);
    return unpacked_.front().second;
  }
  const Chunk& chunk = chunks_.at(index);
  const std::string where = "the chunk at byte " + std::to_string(chunk.offset) + " ";
  auto content = std::make_shared<Bytes>();
  try {
    *content = decompress(chunk.coding, file_.read(chunk.offset, chunk.packed_bytes), chunk.size_bytes);
  } catch (const BagDamage& damage) {
    throw BagDamage(damage.event(), where + damage.what());
  }
  if (chunk.crc != 0 && crc32_z(0, content->data(), content->size()) != chunk.crc) {
    throw BagDamage("sources.bag_damaged", where + "does not have the check sum (CRC-32) that it was written with");
  }
  unpacked_.emplace_front(index, content);
  const auto total = [&] {
    return std::accumulate(unpacked_.begin(), unpacked_.end(), std::size_t{0},
                           [](std::size_t sum, const auto& c) { return sum + c.second->size(); });
  };
  while (unpacked_.size() > 1 && (unpacked_.size() > kMostUnpacked || total() > kMostUnpacked_bytes))
    unpacked_.pop_back();
  return content;
}

std::size_t ChunkedBag::topic(const std::string& name, const std::string& type, Wire wire) {
  const auto [found, isNew] = topicAt_.try_emplace({name, type}, topics_.size());
  if (isNew) topics_.push_back({name, plainTypeName(type), wire, 0});
  return found->second;
}

void ChunkedBag::add(std::size_t topic, std::uint64_t logged_ns, Place place) {
  ++topics_[topic].messages;
  entries_.push_back({topic, static_cast<std::int64_t>(logged_ns)});
  places_.push_back(place);
}

void ChunkedBag::sortByTime() {
  std::vector<std::size_t> order(entries_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [this](std::size_t a, std::size_t b) { return entries_[a].logged_ns < entries_[b].logged_ns; });
  std::vector<Entry> entries;
  std::vector<Place> places;
  entries.reserve(order.size());
  places.reserve(order.size());
  for (const std::size_t i : order) {
    entries.push_back(entries_[i]);
    places.push_back(places_[i]);
  }
  entries_.swap(entries);
  places_.swap(places);
}

std::string plainTypeName(const std::string& type) {
  std::string plain = type;
  for (std::size_t at = 0; (at = plain.find("::")) != std::string::npos;) plain.replace(at, 2, "/");
  if (const std::size_t dds = plain.find("/dds_/"); dds != std::string::npos) {
    plain.erase(dds, 5);
    if (!plain.empty() && plain.back() == '_') plain.pop_back();
  }
  if (const std::size_t msg = plain.find("/msg/"); msg != std::string::npos) plain.erase(msg, 4);
  return plain;
}

}  // namespace wardslam::bags
