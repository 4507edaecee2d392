#include "sqlite_bag.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <array>
#include <string>

#include "chunked_bag.h"
#include "decompress.h"
#include "wardslam/core/errors.h"
#include "wardslam/core/first_bytes.h"

namespace wardslam::bags {
namespace {

constexpr std::array<std::uint8_t, 4> kZstdMagic = {0x28, 0xB5, 0x2F, 0xFD};  // CDR begins with a zero

bool isPacked(const Bytes& message) {
  return message.size() > kZstdMagic.size() && std::equal(kZstdMagic.begin(), kZstdMagic.end(), message.begin());
}

std::uint64_t bigEndian(const std::string& bytes, std::size_t at, std::size_t count) {
  std::uint64_t number = 0;
  for (std::size_t i = at; i < at + count; ++i) number = number << 8U | static_cast<std::uint8_t>(bytes[i]);
  return number;
}

/// "is cut off: 1000 of 4096 bytes are there"; empty where the header counts no more pages than there are. SQLite
/// itself does not mind while nobody asks for the others.
std::string missingPages(const std::filesystem::path& file) {
  constexpr std::size_t kHeader_bytes = 100, kPageSize = 16, kChanges = 24, kPages = 28, kPagesOfChange = 92;
  const std::string header = core::firstBytes(file, kHeader_bytes);
  if (header.size() < kHeader_bytes) return "is cut off within its header";
  const bool isCounted = bigEndian(header, kChanges, 4) == bigEndian(header, kPagesOfChange, 4);
  const std::uint64_t page_bytes = bigEndian(header, kPageSize, 2);
  const std::uint64_t expected = bigEndian(header, kPages, 4) * (page_bytes == 1 ? 65536 : page_bytes);
  const std::uint64_t there = std::filesystem::file_size(file);
  if (!isCounted || there >= expected) return {};
  return "is cut off: " + std::to_string(there) + " of " + std::to_string(expected) + " bytes are there";
}

}  // namespace

SqliteBag::SqliteBag(const std::filesystem::path& path) : path_(path) {
  const std::string missing = missingPages(path);
  try {
    database_ = std::make_unique<SQLite::Database>(path.string(), SQLite::OPEN_READONLY);
    if (!database_->tableExists("topics") || !database_->tableExists("messages")) {
      throw core::InputError(path.string() +
                             ": is an SQLite database but no ROS 2 bag: there are no tables 'topics' and 'messages'");
    }
    listTopics();
    fetch_ = std::make_unique<SQLite::Statement>(*database_, "SELECT data FROM messages WHERE id = ?");
  } catch (const SQLite::Exception& error) {
    throw core::InputError(path.string() + ": cannot be read as a ROS 2 bag: " +
                           (missing.empty() ? error.what() : missing + "; copy it again"));
  }
  try {
    listMessages();
  } catch (const SQLite::Exception& error) {
    damage_.emplace_back("sources.bag_truncated", std::string("is cut off or damaged (") + error.what() + "); the " +
                                                      std::to_string(entries_.size()) +
                                                      " messages that could be listed are read");
  }
  if (damage_.empty() && !missing.empty()) {
    damage_.emplace_back("sources.bag_truncated", missing + "; the messages that are left are read");
  }
}

SqliteBag::~SqliteBag() = default;

void SqliteBag::listTopics() {
  SQLite::Statement rows(*database_, "SELECT id, name, type, serialization_format FROM topics ORDER BY id");
  while (rows.executeStep()) {
    const bool isCdr = rows.getColumn(3).getString() == "cdr";
    topicOf_.emplace_back(rows.getColumn(0).getInt64(), topics_.size());
    topics_.push_back({rows.getColumn(1).getString(), plainTypeName(rows.getColumn(2).getString()),
                       isCdr ? Wire::Cdr : Wire::Unknown, 0});
  }
}

/// By id, so that what is left of a damaged file comes before the damage; then in order of time.
void SqliteBag::listMessages() {
  struct Row {
    Entry entry;
    std::int64_t id = 0;
  };
  std::vector<Row> rows;
  const auto keep = [&] {
    std::stable_sort(rows.begin(), rows.end(),
                     [](const Row& a, const Row& b) { return a.entry.logged_ns < b.entry.logged_ns; });
    for (const Row& row : rows) {
      ++topics_[row.entry.topic].messages;
      entries_.push_back(row.entry);
      ids_.push_back(row.id);
    }
  };
  try {
    SQLite::Statement query(*database_, "SELECT id, topic_id, timestamp FROM messages ORDER BY id");
    while (query.executeStep()) {
      const std::int64_t topic = query.getColumn(1).getInt64();
      const auto known = std::lower_bound(topicOf_.begin(), topicOf_.end(), std::pair(topic, std::size_t{0}));
      if (known == topicOf_.end() || known->first != topic) continue;
      rows.push_back({{known->second, query.getColumn(2).getInt64()}, query.getColumn(0).getInt64()});
    }
  } catch (const SQLite::Exception&) {
    keep();
    throw;
  }
  keep();
}

Bytes SqliteBag::read(std::size_t entry) {
  try {
    fetch_->reset();
    fetch_->bind(1, ids_.at(entry));
    if (!fetch_->executeStep()) throw BagDamage("sources.bag_damaged", "is no longer in the database");
    const SQLite::Column blob = fetch_->getColumn(0);
    const auto* first = static_cast<const std::uint8_t*>(blob.getBlob());
    Bytes message(first, first + blob.getBytes());
    return isPacked(message) ? decompressZstd(message) : message;
  } catch (const SQLite::Exception& error) {
    throw BagDamage("sources.bag_damaged", std::string("cannot be read from the database: ") + error.what());
  }
}

}  // namespace wardslam::bags
