#pragma once

#include <memory>

#include "wardslam/bags/bag_reader.h"

namespace SQLite {  // NOLINT(readability-identifier-naming)
class Database;
class Statement;
}  // namespace SQLite

namespace wardslam::bags {

/// A file of a ROS 2 bag in the storage "sqlite3" of rosbag2 (.db3): its tables `topics` and `messages`. Messages may
/// be packed one by one (compression_mode MESSAGE), which their first bytes tell.
class SqliteBag : public BagReader {
 public:
  /// Throws core::InputError where it is no such database.
  explicit SqliteBag(const std::filesystem::path& path);
  ~SqliteBag() override;

  [[nodiscard]] Bytes read(std::size_t entry) override;

  static constexpr const char* kMagic = "SQLite format 3";

 private:
  void listTopics();
  void listMessages();

  std::filesystem::path path_;
  std::unique_ptr<SQLite::Database> database_;
  std::unique_ptr<SQLite::Statement> fetch_;
  std::vector<std::int64_t> ids_;                              ///< Of entries_.
  std::vector<std::pair<std::int64_t, std::size_t>> topicOf_;  ///< By id.
};

}  // namespace wardslam::bags
