#include "digest.h"

#include <cstdint>

#include "wardslam/core/digest.h"

namespace wardslam::reproduction {

namespace fs = std::filesystem;

std::string digestOfFile(const fs::path& file) {
  return fs::is_regular_file(file) ? core::digestOfFile(file) : "absent";
}

std::string extentOfFolder(const fs::path& folder) {
  std::error_code error;
  std::uint64_t files = 0;
  std::uint64_t bytes = 0;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (!entry.is_regular_file(error)) continue;
    ++files;
    bytes += entry.file_size(error);
  }
  if (error) return "absent";
  return std::to_string(files) + " files, " + std::to_string(bytes) + " bytes";
}

}  // namespace wardslam::reproduction
