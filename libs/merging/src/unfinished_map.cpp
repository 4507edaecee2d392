#include "unfinished_map.h"

#include <array>
#include <utility>

#include "wardslam/core/atomic_file.h"

namespace wardslam::merging {
namespace {

constexpr std::array kJournals = {"-journal", "-wal", "-shm"};

void removeJournals(const std::filesystem::path& file) {
  for (const char* suffix : kJournals) {
    std::error_code ignored;
    std::filesystem::remove(file.string() + suffix, ignored);
  }
}

}  // namespace

UnfinishedMap::UnfinishedMap(std::filesystem::path file, const storage::MapHeader& header,
                             const storage::MapChanges& content)
    : file_(std::move(file)), partial_(file_.string() + ".partial") {
  map_.emplace(storage::MapFile::create(partial_, header, content));
}

UnfinishedMap::~UnfinishedMap() {
  if (!map_) return;
  map_.reset();
  std::error_code ignored;
  std::filesystem::remove(partial_, ignored);
  removeJournals(partial_);
}

void UnfinishedMap::finish() {
  map_->compact();
  map_.reset();
  removeJournals(file_);  // of the map that was there; they would be played back into the new one
  core::replaceFile(partial_, file_);
}

}  // namespace wardslam::merging
