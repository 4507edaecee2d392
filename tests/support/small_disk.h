#pragma once

#include <sys/mount.h>

#include <filesystem>
#include <string>

namespace wardslam::test {

/// A file system of its own at a folder, in memory, as large as is said. Needs root.
class SmallDisk {
 public:
  SmallDisk(const std::filesystem::path& folder, std::size_t size_kb) : folder_(folder) {
    std::filesystem::create_directories(folder);
    const std::string size = "size=" + std::to_string(size_kb) + "k";
    isThere_ = ::mount("tmpfs", folder.c_str(), "tmpfs", 0, size.c_str()) == 0;
  }
  ~SmallDisk() {
    if (isThere_) ::umount2(folder_.c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  [[nodiscard]] bool isThere() const { return isThere_; }

  /// As a card whose slide says so, or one that has failed.
  [[nodiscard]] bool protect() const {
    return ::mount("tmpfs", folder_.c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr) == 0;
  }

 private:
  std::filesystem::path folder_;
  bool isThere_ = false;
};

}  // namespace wardslam::test
