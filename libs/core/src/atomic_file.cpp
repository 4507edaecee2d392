#include "wardslam/core/atomic_file.h"

#include <system_error>
#include <utility>

#include "wardslam/core/errors.h"

namespace wardslam::core {

AtomicFile::AtomicFile(std::filesystem::path file)
    : file_(std::move(file)), partial_(file_.string() + ".partial"), stream_(partial_) {
  if (!stream_) throw InputError(partial_.string() + ": cannot be created; is the folder there and writable?");
}

void AtomicFile::commit() {
  stream_.close();
  if (!stream_) throw InputError(partial_.string() + ": could not be written in full; is the disk full?");
  std::error_code error;
  std::filesystem::rename(partial_, file_, error);
  if (error) throw InputError(file_.string() + ": cannot be replaced: " + error.message());
}

void writeFileAtomically(const std::filesystem::path& file, const std::string& text) {
  AtomicFile out(file);
  out.stream() << text;
  out.commit();
}

}  // namespace wardslam::core
