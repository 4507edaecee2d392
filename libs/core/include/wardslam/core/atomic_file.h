#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

namespace wardslam::core {

/// A text file that is complete or absent: written as "<name>.partial", which commit() renames. Without commit()
/// the partial file stays (what was written is not lost) but never passes for the finished one.
class AtomicFile {
 public:
  /// Throws InputError when the file cannot be created.
  explicit AtomicFile(std::filesystem::path file);

  [[nodiscard]] std::ostream& stream() { return stream_; }

  /// Flushes and renames; throws InputError when the disk did not take all of it.
  void commit();

 private:
  std::filesystem::path file_;
  std::filesystem::path partial_;
  std::ofstream stream_;
};

/// For libraries that write files themselves: `write` gets the name to write to, which is then renamed. Throws what it
/// throws, and InputError when the file cannot be replaced.
void replaceAtomically(const std::filesystem::path& file,
                       const std::function<void(const std::filesystem::path& partial)>& write);

/// Writes the whole text in one go.
void writeFileAtomically(const std::filesystem::path& file, const std::string& text);

}  // namespace wardslam::core
