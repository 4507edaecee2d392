#include "wardslam/core/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <streambuf>
#include <system_error>
#include <utility>

#include "wardslam/core/errors.h"

namespace wardslam::core {
namespace {

constexpr std::size_t kBuffered = 64UL << 10U;
constexpr std::size_t kMostKept = 64UL << 20U;  ///< While the disk takes nothing: more is given up.

std::filesystem::path partialOf(const std::filesystem::path& file) { return file.string() + ".partial"; }

std::filesystem::path folderOf(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

/// Renaming puts a file in the place of whatever is there.
void requireReplaceable(const std::filesystem::path& file) {
  std::error_code none;
  const auto type = std::filesystem::status(file, none).type();
  using Type = std::filesystem::file_type;
  if (type == Type::character || type == Type::block || type == Type::fifo || type == Type::socket)
    throw InputError(file.string() + ": is a device or a pipe, and would be replaced by a file; name a file");
}

}  // namespace

/// What is on its way into a file. A standard file buffer forgets what the disk did not take.
class AtomicFile::Buffer : public std::streambuf {
 public:
  explicit Buffer(const std::filesystem::path& file)
      : descriptor_(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {}
  ~Buffer() override { close(); }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  [[nodiscard]] bool isOpen() const { return descriptor_ >= 0; }
  [[nodiscard]] bool isBehind() const { return isBehind_; }

  /// True: the disk has all of it.
  bool writeOut() {
    std::size_t written = 0;
    while (written < waiting_.size()) {
      const ssize_t taken = ::write(descriptor_, waiting_.data() + written, waiting_.size() - written);
      if (taken < 0 && errno == EINTR) continue;
      if (taken <= 0) break;
      written += static_cast<std::size_t>(taken);
    }
    waiting_.erase(0, written);
    isBehind_ = !waiting_.empty();
    return !isBehind_;
  }

  void close() {
    if (!isOpen()) return;
    writeOut();
    ::close(std::exchange(descriptor_, -1));
  }

 protected:
  int overflow(int character) override {
    if (traits_type::eq_int_type(character, traits_type::eof())) return traits_type::not_eof(character);
    waiting_.push_back(traits_type::to_char_type(character));
    return makeRoom() ? character : traits_type::eof();
  }
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    waiting_.append(text, static_cast<std::size_t>(size));
    return makeRoom() ? size : 0;
  }
  int sync() override {
    writeOut();
    return 0;  // what the disk did not take is not lost
  }

 private:
  bool makeRoom() {
    if (waiting_.size() < kBuffered || (isBehind_ && waiting_.size() < kMostKept)) return true;
    return writeOut() || waiting_.size() < kMostKept;
  }

  int descriptor_;
  std::string waiting_;
  bool isBehind_ = false;
};

AtomicFile::AtomicFile(std::filesystem::path file)
    : file_(std::move(file)),
      partial_(partialOf(file_)),
      buffer_((requireReplaceable(file_), std::make_unique<Buffer>(partial_))),
      stream_(buffer_.get()) {
  if (!buffer_->isOpen()) {
    throw InputError(partial_.string() + ": cannot be created; is the folder there and writable?");
  }
}

AtomicFile::~AtomicFile() = default;

bool AtomicFile::isBehind() const { return buffer_->isBehind(); }

void AtomicFile::commit() {
  if (!stream_ || !buffer_->writeOut()) {
    throw InputError(partial_.string() + ": could not be written in full; is the disk full?");
  }
  buffer_->close();
  syncToDisk(partial_);
  replaceFile(partial_, file_);
}

void replaceAtomically(const std::filesystem::path& file,
                       const std::function<void(const std::filesystem::path& partial)>& write) {
  requireReplaceable(file);
  write(partialOf(file));
  syncToDisk(partialOf(file));
  replaceFile(partialOf(file), file);
}

void writeFileAtomically(const std::filesystem::path& file, const std::string& text) {
  AtomicFile out(file);
  out.stream() << text;
  out.commit();
}

void syncToDisk(const std::filesystem::path& fileOrFolder) {
  const int descriptor = ::open(fileOrFolder.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return;
  const int error = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  if (error == EIO || error == ENOSPC || error == EDQUOT) {
    throw InputError(fileOrFolder.string() + ": could not be written in full; is the disk full?");
  }
}

void replaceFile(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::error_code error;
  std::filesystem::rename(from, to, error);
  if (error) throw InputError(to.string() + ": cannot be replaced: " + error.message());
  syncToDisk(folderOf(to));
}

}  // namespace wardslam::core
