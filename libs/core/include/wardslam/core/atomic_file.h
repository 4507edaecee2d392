#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <ostream>
#include <string>

namespace wardslam::core {

/// A text file that is complete or absent: written as "<name>.partial", which commit() renames. Without commit()
/// the partial file stays (what was written is not lost) but never passes for the finished one. What the disk does not
/// take is kept and tried again, so that a disk that is full for a moment costs nothing.
class AtomicFile {
 public:
  /// Throws InputError when the file cannot be created.
  explicit AtomicFile(std::filesystem::path file);
  ~AtomicFile();  ///< Without commit(), writes what it can to the partial file.
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  [[nodiscard]] std::ostream& stream() { return stream_; }

  /// Whether the disk did not take all that was flushed; the next flush tries again.
  [[nodiscard]] bool isBehind() const;

  /// Flushes and renames; when it returns, the file survives a power cut. Throws InputError when the disk did not take
  /// all of it; may be tried again then.
  void commit();

 private:
  class Buffer;

  std::filesystem::path file_;
  std::filesystem::path partial_;
  std::unique_ptr<Buffer> buffer_;
  std::ostream stream_;
};

/// For libraries that write files themselves: `write` gets the name to write to, which is then renamed. Throws what it
/// throws, and InputError when the file cannot be replaced.
void replaceAtomically(const std::filesystem::path& file,
                       const std::function<void(const std::filesystem::path& partial)>& write);

/// Writes the whole text in one go.
void writeFileAtomically(const std::filesystem::path& file, const std::string& text);

/// Has the disk take over what was written to a file, or which files a folder holds; a file system that cannot is let
/// pass. Throws InputError when the disk fails, or is full.
void syncToDisk(const std::filesystem::path& fileOrFolder);

/// Renames within a folder, in place of what may be there; survives a power cut. Throws InputError.
void replaceFile(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace wardslam::core
