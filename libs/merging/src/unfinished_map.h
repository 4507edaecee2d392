#pragma once

#include <filesystem>
#include <optional>

#include "wardslam/storage/map_file.h"

namespace wardslam::merging {

/// A map that is written bit by bit, beside its name until it is complete. One that does not come so far is removed.
class UnfinishedMap {
 public:
  /// What is under that name stays. Throws core::InputError.
  UnfinishedMap(std::filesystem::path file, const storage::MapHeader& header, const storage::MapChanges& content);
  ~UnfinishedMap();
  UnfinishedMap(const UnfinishedMap&) = delete;
  UnfinishedMap& operator=(const UnfinishedMap&) = delete;

  void write(const storage::MapChanges& changes) { map_->write(changes); }

  /// As small as it can be, in place of what is under the name. Throws core::InputError.
  void finish();

 private:
  std::filesystem::path file_;
  std::filesystem::path partial_;
  std::optional<storage::MapFile> map_;
};

}  // namespace wardslam::merging
