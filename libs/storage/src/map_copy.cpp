#include "wardslam/storage/map_copy.h"

#include <system_error>
#include <utility>

#include "wardslam/core/errors.h"
#include "wardslam/storage/map_file.h"

namespace wardslam::storage {

MapCopy::MapCopy(std::filesystem::path map) : map_(std::move(map)), copy_(map_.string() + ".grown") {
  static_cast<void>(MapFile::open(map_, MapAccess::Write));  // or it could not be replaced in the end
  putAsideWhatWasLeftBehind();
  MapFile::copy(map_, copy_);
}

void MapCopy::putAsideWhatWasLeftBehind() {
  if (!std::filesystem::exists(copy_)) return;
  try {  // which takes back a change that was begun and not ended
    static_cast<void>(MapFile::open(copy_, MapAccess::Write));
  } catch (const core::InputError&) {
    return;  // nothing that could be used
  }
  const std::filesystem::path aside = copy_.string() + ".old";
  std::error_code error;
  std::filesystem::rename(copy_, aside, error);
  if (error) throw core::InputError(copy_.string() + ": cannot be put aside: " + error.message());
  leftBehind_ = aside;
}

void MapCopy::takePlace() const {
  std::error_code error;
  std::filesystem::rename(copy_, map_, error);
  if (error) {
    throw core::InputError(map_.string() + ": cannot be replaced: " + error.message() + "; the map of this run is " +
                           copy_.string());
  }
}

void MapCopy::remove() const {
  std::error_code error;
  std::filesystem::remove(copy_, error);
  if (error) throw core::InputError(copy_.string() + ": cannot be removed: " + error.message());
}

}  // namespace wardslam::storage
