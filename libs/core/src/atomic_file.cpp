#include "wardslam/core/atomic_file.h"

#include <system_error>
#include <utility>

#include "wardslam/core/errors.h"

namespace wardslam::core {

namespace {

std::filesystem::path partialOf(const std::filesystem::path& file) { return file.string() + ".partial"; }

void replace(const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::rename(partialOf(file), file, error);
  if (error) throw InputError(file.string() + ": cannot be replaced: " + error.message());
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path file)
    : file_(std::move(file)), partial_(partialOf(file_)), stream_(partial_) {
  if (!stream_) throw InputError(partial_.string() + ": cannot be created; is the folder there and writable?");
}

void AtomicFile::commit() {
  stream_.close();
  if (!stream_) throw InputError(partial_.string() + ": could not be written in full; is the disk full?");
  replace(file_);
}

void replaceAtomically(const std::filesystem::path& file,
                       const std::function<void(const std::filesystem::path& partial)>& write) {
  write(partialOf(file));
  replace(file);
}

void writeFileAtomically(const std::filesystem::path& file, const std::string& text) {
  AtomicFile out(file);
  out.stream() << text;
  out.commit();
}

}  // namespace wardslam::core
