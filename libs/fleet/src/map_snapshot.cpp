#include "map_snapshot.h"

#include <algorithm>
#include <cstdlib>

#include "wardslam/building/rooms_of_map.h"
#include "wardslam/core/errors.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::fleet {
namespace {

namespace fs = std::filesystem;

fs::path makeTemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "wardslam_push_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw core::InputError(name + ": cannot be made; is the disk full?");
  return name;
}

bool isBeingWritten(const fs::path& file) { return fs::exists(file.string() + "-journal"); }

/// Byte for byte where nobody writes to it meanwhile; else what it held at one moment.
void copyMap(const fs::path& from, const fs::path& to) {
  if (!isBeingWritten(from)) {
    (void)storage::MapFile::open(from, storage::MapAccess::Untouched).info();
    const auto before = fs::last_write_time(from);
    std::error_code error;
    fs::copy_file(from, to, fs::copy_options::overwrite_existing, error);
    if (error) throw core::InputError(to.string() + ": cannot be written: " + error.message());
    if (!isBeingWritten(from) && fs::last_write_time(from) == before) return;
  }
  storage::MapFile::copy(from, to);
}

}  // namespace

MapSnapshot::MapSnapshot(const fs::path& file) : folder_(makeTemporaryFolder()), copy_(folder_ / file.filename()) {
  try {
    read(file);
  } catch (...) {
    fs::remove_all(folder_);
    throw;
  }
}

MapSnapshot::~MapSnapshot() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void MapSnapshot::read(const fs::path& original) {
  copyMap(original, copy_);
  digests_ = digestsOf(copy_);
  const auto stored = storage::MapFile::open(copy_, storage::MapAccess::Untouched);
  map_ = stored.readWithFloorPlan(storage::CloudPart::LeaveOut);
  rooms_ = building::roomsOf(map_);
  for (const auto& [id, object] : stored.readObjectMemories()) traces_[id] = {object.handled_s, object.gone_s};
  for (const auto& [id, keyframe] : map_.keyframes) {
    first_s_ = first_s_ == 0.0 ? keyframe.stamp_s : std::min(first_s_, keyframe.stamp_s);
    last_s_ = std::max(last_s_, keyframe.stamp_s);
  }
}

Traces MapSnapshot::tracesOf(mapping::ObjectId object) const {
  const auto found = traces_.find(object);
  return found == traces_.end() ? Traces{} : found->second;
}

}  // namespace wardslam::fleet
